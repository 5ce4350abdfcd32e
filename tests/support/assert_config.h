/* Core's configuration for tests of broken contracts: counts them, and hints.
 */
#ifndef TESTS_SUPPORT_ASSERT_CONFIG_H
#define TESTS_SUPPORT_ASSERT_CONFIG_H

void assert_broken(void);
void hint_given(void);

#define PEL_ASSERT(condition) ((condition) ? (void)0 : assert_broken())
#define PEL_HINT(condition) ((condition) ? (void)0 : hint_given())

#endif

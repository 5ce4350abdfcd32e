/* Core's configuration for tests of broken contracts: counts them. */
#ifndef TESTS_SUPPORT_ASSERT_CONFIG_H
#define TESTS_SUPPORT_ASSERT_CONFIG_H

void assert_broken(void);

#define PEL_ASSERT(condition) ((condition) ? (void)0 : assert_broken())

#endif

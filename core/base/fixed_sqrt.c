#include "fixed_sqrt.h"

#include "fixed_root.h"

void pel_root_guess(uint64_t v, struct pel_root *r)
{
    pel_root_guess_of(v, r);
}

void pel_root_settle(uint64_t v, struct pel_root *r)
{
    pel_root_settle_of(v, r);
}

/* toy: a stage that only a test has, to see what a stage takes. One work-item per value. */
#include "kernels.h"

KERNEL(toy, ToyParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    multiples[i] = args.factor * values[i];
}

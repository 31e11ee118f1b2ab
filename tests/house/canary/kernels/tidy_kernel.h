// bites: [readability-identifier-naming,-warnings-as-errors]
#ifndef MAYFLY_CANARY_KERNEL_H
#define MAYFLY_CANARY_KERNEL_H

static inline float half_of(float a) { return 0.5F * a; }

#endif

// Counts what becomes of the flakes, in the order of the fields of Ledger in ledger.hpp.

#include "common/bindings.glsl"

layout(binding = LEDGER_BUFFER, offset = 0) uniform atomic_uint released;
layout(binding = LEDGER_BUFFER, offset = 4) uniform atomic_uint deposited;
layout(binding = LEDGER_BUFFER, offset = 8) uniform atomic_uint melted;
layout(binding = LEDGER_BUFFER, offset = 12) uniform atomic_uint left_world;

void count_release() { atomicCounterIncrement(released); }
void count_deposit() { atomicCounterIncrement(deposited); }

// A flake is no more: it has melted, or else it has left the world or outlived its time.
void count_end(bool has_melted)
{
    if (has_melted) {
        atomicCounterIncrement(melted);
    } else {
        atomicCounterIncrement(left_world);
    }
}

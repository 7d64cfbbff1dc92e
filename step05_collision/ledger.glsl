// Counts what becomes of the flakes, in the order of the fields of Ledger in ledger.hpp.

layout(binding = 0, offset = 0) uniform atomic_uint released;
layout(binding = 0, offset = 4) uniform atomic_uint deposited;
layout(binding = 0, offset = 8) uniform atomic_uint melted;
layout(binding = 0, offset = 12) uniform atomic_uint left_world;

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

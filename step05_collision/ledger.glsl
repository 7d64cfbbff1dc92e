// Counts what becomes of the flakes, in the order of the fields of Counts in ledger.cpp. Each number has two
// words, the low one and its carries: with 50 million flakes the low one is full after some 20 minutes.
// A vertex shader may run more than once for a vertex (OpenGL 4.6, 7.13.1), and would then count too much.

#include "common/bindings.glsl"

layout(binding = LEDGER_BUFFER, offset = 0) uniform atomic_uint released;
layout(binding = LEDGER_BUFFER, offset = 4) uniform atomic_uint released_carry;
layout(binding = LEDGER_BUFFER, offset = 8) uniform atomic_uint deposited;
layout(binding = LEDGER_BUFFER, offset = 12) uniform atomic_uint deposited_carry;
layout(binding = LEDGER_BUFFER, offset = 16) uniform atomic_uint melted;
layout(binding = LEDGER_BUFFER, offset = 20) uniform atomic_uint melted_carry;
layout(binding = LEDGER_BUFFER, offset = 24) uniform atomic_uint left_world;
layout(binding = LEDGER_BUFFER, offset = 28) uniform atomic_uint left_world_carry;

void count(atomic_uint low, atomic_uint carry)
{
    // It returns the value before.
    if (atomicCounterIncrement(low) == 0xffffffffu) atomicCounterIncrement(carry);
}

void count_release() { count(released, released_carry); }
void count_deposit() { count(deposited, deposited_carry); }

// A flake is no more: it has melted, or else it has left the world or outlived its time.
void count_end(bool has_melted)
{
    if (has_melted) {
        count(melted, melted_carry);
    } else {
        count(left_world, left_world_carry);
    }
}

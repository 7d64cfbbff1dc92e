#version 430 core
// Counts a flake's whole life in each invocation, for ledger_test.cpp.

#include "step05_collision/ledger.glsl"

layout(local_size_x = 64) in;

void main()
{
    count_release();
    count_deposit();
    count_end(true);
    count_end(false);
}

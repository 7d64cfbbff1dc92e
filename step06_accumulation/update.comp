#version 430 core
// The variant "cells": the air moves as in every step before.

#include "step06_accumulation/cover/update.glsl"
#include "step06_accumulation/cover/deposit.glsl"

vec3 air_at(vec3 position)
{
    return weather.wind;
}

void main()
{
    if (first + gl_GlobalInvocationID.x < weather.particles) update_flake();
}

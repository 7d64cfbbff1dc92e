#version 430 core
// The variant "cells": the air moves as in every step before.

#include "common/weather_block.glsl"

vec3 air_at(vec3 position)
{
    return weather.wind;
}

#include "step06_accumulation/cover/update.glsl"

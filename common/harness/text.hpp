// Text, compared without regard to capitals.
#pragma once

#include <string>
#include <string_view>

// With the letters A to Z made small.
std::string lower_case(std::string_view text);

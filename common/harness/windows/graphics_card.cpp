// A laptop with two graphics cards runs a program on the fast one if the program itself, not a
// library of it, exports these names.
extern "C" {
__declspec(dllexport) unsigned long NvOptimusEnablement = 1;
__declspec(dllexport) int AmdPowerXpressRequestHighPerformance = 1;
}

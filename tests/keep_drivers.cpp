// Loaded into a program with LD_PRELOAD when leaks are looked for: OpenGL's driver is unloaded at
// the end, and then the report of what it leaked can no longer name it, nor leaks.supp match the
// name.
extern "C" int dlclose(void*)
{
    return 0;  // done, it says, and keeps the library
}

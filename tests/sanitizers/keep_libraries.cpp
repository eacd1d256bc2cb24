// Keeps libraries loaded. So a driver's leaks carry the driver's name when the process ends, and
// can be told from leaks of this program.
extern "C" int dlclose(void*) {
    return 0;
}

// Libraries stay loaded: what a driver leaks has the driver's name when the process ends, and can
// be told from what is ours.
extern "C" int dlclose(void*) {
    return 0;
}

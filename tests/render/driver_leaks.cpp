// Mesa keeps what it compiled for the process's lifetime; leaks of our own are still reported.

extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libEGL\nleak:libGLX\nleak:libGLdispatch\nleak:swrast_dri.so\nleak:libgallium\nleak:libLLVM\n"
           "leak:libX11\nleak:libxcb\n";
}

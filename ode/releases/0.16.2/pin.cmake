# ODE 0.16.2 (July 2020): Debian 11 and 12, Ubuntu 22.04 and 24.04.
set(ODE_MT_UPSTREAM_SHA256 b26aebdcb015e2d89720ef48e0cb2e8a3ca77915f89d853893e7cc861f810f22)
set(ODE_MT_UPSTREAM_URL https://bitbucket.org/odedevs/ode/downloads/ode-0.16.2.tar.gz)
set(ODE_MT_UPSTREAM_LIBRARY 8.0.2)  # the file is libode.so.8.0.2

# The Debian release that has it, and its package, which libode.so.8 takes the place of.
set(ODE_MT_DEBIAN_SUITE bookworm)
set(ODE_MT_DEBIAN_PACKAGE libode8)
set(ODE_MT_DEBIAN_VERSION 2:0.16.2-1)

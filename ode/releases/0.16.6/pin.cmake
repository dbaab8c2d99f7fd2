# ODE 0.16.6 (January 2025): Debian 13, Ubuntu 25.10, and most package managers beside Debian's.
set(ODE_MT_UPSTREAM_SHA256 c91a28c6ff2650284784a79c726a380d6afec87ecf7a35c32a6be0c5b74513e8)
set(ODE_MT_UPSTREAM_URL https://bitbucket.org/odedevs/ode/downloads/ode-0.16.6.tar.gz)
set(ODE_MT_UPSTREAM_LIBRARY 8.2.0)  # the file is libode.so.8.2.0

# The Debian release that has it, and its package, which libode.so.8 takes the place of.
set(ODE_MT_DEBIAN_SUITE trixie)
set(ODE_MT_DEBIAN_PACKAGE libode8t64)
set(ODE_MT_DEBIAN_VERSION 2:0.16.6-2)

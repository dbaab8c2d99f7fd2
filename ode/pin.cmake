# The upstream release this fork is made of. Nothing else is accepted.
set(ODE_MT_UPSTREAM_VERSION 0.16.2)
set(ODE_MT_UPSTREAM_ARCHIVE ode_${ODE_MT_UPSTREAM_VERSION}.orig.tar.gz)
set(ODE_MT_UPSTREAM_SHA256 b26aebdcb015e2d89720ef48e0cb2e8a3ca77915f89d853893e7cc861f810f22)
set(ODE_MT_UPSTREAM_URL
    https://bitbucket.org/odedevs/ode/downloads/ode-${ODE_MT_UPSTREAM_VERSION}.tar.gz)
# The Debian package of it that libode.so.8 takes the place of, for programs that depend on that.
set(ODE_MT_DEBIAN_VERSION 2:0.16.2-1)

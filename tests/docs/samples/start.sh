# Commands of docs/start.md, in a folder with first_world.c. run_samples.sh puts the installed tree in the place of /opt/ode_mt.

# [compile]
cc first_world.c -o first_world $(pkg-config --cflags --libs ode)
./first_world
# [compile]

# [switch]
LD_LIBRARY_PATH=/opt/ode_mt/lib ODE_MT_THREADS=auto ./first_world
# [switch]

# [which]
LD_LIBRARY_PATH=/opt/ode_mt/lib ldd ./first_world | grep libode
LD_LIBRARY_PATH=/opt/ode_mt/lib ODE_MT_THREADS=auto ODE_MT_LOG=info ./first_world
# [which]

# [own]
export PKG_CONFIG_PATH=/opt/ode_mt/lib/pkgconfig
cc first_world.c -o first_world $(pkg-config --cflags --libs ode) -Wl,-rpath,/opt/ode_mt/lib
./first_world
# [own]

# Seams of ODE 0.16.6 alone.

# A limit that the program sets for solving an island holds for ours, too; upstream's default does not
# (ode/releases/0.16.6/stepping_threads.cpp).
ode_mt_rename(ode.cpp dWorldSetSteppingThreadingParameters)
set(ODE_MT_RELEASE_SOURCES stepping_threads.cpp)

# The order of arguments that decides the sign of a zero is that of Debian 13's binary (docs/exactness.md).
ode_mt_compile_after(collision_libccd.cpp "${CMAKE_CURRENT_LIST_DIR}/fmax_order.h")

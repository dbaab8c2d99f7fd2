# Hardening as Debian's packages have it (dpkg-buildflags with hardening=+all), for the library and the tools:
# docs/packages.md says what each option is against, tests/security reads it off what was built.
include(CMakeDependentOption)
# Sanitizers watch the stack and the copies themselves, and do not know the checked variants of the C library's functions.
cmake_dependent_option(ODE_MT_HARDENING "Build with stack protector and checked copies, and link position-independent programs"
    ON "NOT ODE_MT_SANITIZER" OFF)
include(CheckPIESupported)
check_pie_supported(LANGUAGES CXX)

# For targets that the calling folder and those below it define from here on.
macro(ode_mt_harden)
    # These cost nothing at run time, so that they are no option: a relocation table that cannot be written, all functions
    # bound when the program starts, no code on the stack, no relocation in code.
    add_link_options("LINKER:-z,relro" "LINKER:-z,now" "LINKER:-z,noexecstack" "LINKER:-z,text")
    if(ODE_MT_HARDENING)
        add_compile_options(-fstack-protector-strong -Wformat -Werror=format-security)
        # Only an optimising compiler knows the sizes. Some compilers define a level of their own.
        add_compile_options($<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE> $<$<NOT:$<CONFIG:Debug>>:-D_FORTIFY_SOURCE=2>)
        set(CMAKE_POSITION_INDEPENDENT_CODE ON)  # and so executables are linked with -pie
    endif()
endmacro()

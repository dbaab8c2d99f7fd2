# Counts of the lines and branches of ode_mt/ that tests run, for .ci/coverage.
option(ODE_MT_COVERAGE "Count which lines of ode_mt/ are run (gcov)" OFF)

# Workers count at the same time. -O1 keeps lines apart.
set(ODE_MT_COVERAGE_OPTIONS --coverage -fprofile-update=atomic)

# For targets that the calling folder and those below it define from here on.
macro(ode_mt_count_coverage)
    if(ODE_MT_COVERAGE)
        add_compile_options(${ODE_MT_COVERAGE_OPTIONS})
    endif()
endmacro()

# Upstream's files that templates of ode_mt/ are compiled into; of upstream itself nothing is counted.
function(ode_mt_count_coverage_of)
    if(ODE_MT_COVERAGE)
        set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS ${ODE_MT_COVERAGE_OPTIONS})
    endif()
endfunction()

if(ODE_MT_COVERAGE)
    add_link_options(--coverage)  # test programs link objects of ode_mt/ themselves
endif()

# cmake -DODE_MT_UPSTREAM=RELEASE [-DODE_MT_CACHE_DIR=...] -P ode/unpack.cmake: unpacks a release's sources into ode/upstream/.
include("${CMAKE_CURRENT_LIST_DIR}/fetch.cmake")
ode_mt_unpack_upstream(folder)
message(STATUS "unpacked in ${folder}")

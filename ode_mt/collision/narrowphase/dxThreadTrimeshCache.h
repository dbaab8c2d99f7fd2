// The scratch data of upstream's mesh colliders, one for each thread that collides meshes.
//
// Upstream has one for the whole process, unless it is built with thread-local storage, which would change
// what callers see. The cache is made at a thread's first use and freed when the thread ends, when the
// library is closed by the last user, or when it is unloaded. It does not use a C++ thread_local object:
// that would keep the library from being unloaded.
#pragma once

namespace dxThreadTrimeshCache {

// Frees the caches of all threads (dCloseODE). No thread may be colliding meshes.
void release();

// Frees them permanently, with the C library's key (unloading, or the end of the process, whose other threads may still
// be colliding: theirs are kept).
void unload();

}  // namespace dxThreadTrimeshCache

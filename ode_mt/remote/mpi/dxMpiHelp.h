// Help texts of Open MPI, such as the one that a peer has hung up, are written by the process that has them.
//
// Open MPI 4 sends them to mpirun (or orted), which reads a message after it has told another thread to free it (orte_rml_oob_send_buffer_nb gives
// it away before it copies it): now and then mpirun crashes, and ends the job that was to survive a lost worker. Elsewhere nothing is changed.
#pragma once

// After MPI has been initialised. Threading: any thread, once.
void dxWriteMpiHelpHere();

#pragma once

// Thrown through upstream's code to leave an island that has to be stepped in order on the caller's thread.
struct dxUpstreamInterrupted {};

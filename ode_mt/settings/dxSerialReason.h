// The words for each dODE_MT_Reason.
#pragma once

// Half a sentence; for numbers that are no reason, too.
const char *dxTextOfReason(int reason);

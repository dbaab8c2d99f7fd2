/* Records a part of a program's run, for docs/tools.md. */
#include <stdio.h>
#include <stdlib.h>

#include "towers.h"

static void recordFrames(void) {
/* [record] */
dODE_MT_StartTrace("trace.json"); /* 0 and a message if the file cannot be written */
runFrames(100);
dODE_MT_StopTrace();              /* writes it; dODE_MT_FlushTrace() writes it and goes on */
/* [record] */
}

int main(void) {
    dInitODE2(0);
    dToggleODE_MT(2);
    setUpTowers();
    recordFrames();
    destroyTowers();
    dCloseODE();
    FILE *const file = fopen("trace.json", "r");
    char begin[17] = "";
    const int isWritten = file != NULL && fread(begin, 1, 16, file) == 16 && begin[0] == '{';
    if (file != NULL) fclose(file);
    remove("trace.json");
    return isWritten ? EXIT_SUCCESS : EXIT_FAILURE;
}

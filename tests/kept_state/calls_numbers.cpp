// Recipes for functions that keep nothing of the caller's: masses, matrices, rotations, vectors, the timer.
#include "call_recipes.h"
#include "call_shapes.h"

#include <cstdio>

namespace kept_state {

namespace {

const dMatrix3 kTurn{0.36, 0.48, -0.8, 0, -0.8, 0.6, 0, 0, 0.48, 0.64, 0.6, 0};

void addMasses(CallRecipes &r) {
    const auto mass = [&](const char *name, void (*change)(dMass *, CallScene &)) {
        r.push_back({name,
                     [change](CallScene &s) {
                         dMass m;
                         dMassSetBox(&m, 2, 0.3, 0.4, 0.5);
                         change(&m, s);
                         s.tell(m.mass);
                         s.tell(m.c, 3);
                         s.tell(m.I, 12);
                     },
                     nullptr, true});
    };
    mass("dMassCheck", [](dMass *m, CallScene &s) { s.tell(dMassCheck(m)); });
    mass("dMassSetZero", [](dMass *m, CallScene &) { dMassSetZero(m); });
    mass("dMassSetParameters",
         [](dMass *m, CallScene &) { dMassSetParameters(m, 2, 0, 0, 0, 1, 1.1, 1.2, 0.1, 0.05, 0.02); });
    mass("dMassSetSphere", [](dMass *m, CallScene &) { dMassSetSphere(m, 2, 0.3); });
    mass("dMassSetSphereTotal", [](dMass *m, CallScene &) { dMassSetSphereTotal(m, 2, 0.3); });
    mass("dMassSetCapsule", [](dMass *m, CallScene &) { dMassSetCapsule(m, 2, 3, 0.3, 0.5); });
    mass("dMassSetCapsuleTotal", [](dMass *m, CallScene &) { dMassSetCapsuleTotal(m, 2, 2, 0.3, 0.5); });
    mass("dMassSetCylinder", [](dMass *m, CallScene &) { dMassSetCylinder(m, 2, 3, 0.3, 0.5); });
    mass("dMassSetCylinderTotal", [](dMass *m, CallScene &) { dMassSetCylinderTotal(m, 2, 1, 0.3, 0.5); });
    mass("dMassSetCappedCylinder", [](dMass *m, CallScene &) { dMassSetCappedCylinder(m, 2, 3, 0.3, 0.5); });
    mass("dMassSetCappedCylinderTotal",
         [](dMass *m, CallScene &) { dMassSetCappedCylinderTotal(m, 2, 3, 0.3, 0.5); });
    mass("dMassSetBox", [](dMass *m, CallScene &) { dMassSetBox(m, 2, 0.3, 0.6, 0.5); });
    mass("dMassSetBoxTotal", [](dMass *m, CallScene &) { dMassSetBoxTotal(m, 2, 0.3, 0.6, 0.5); });
    mass("dMassSetTrimesh", [](dMass *m, CallScene &s) { dMassSetTrimesh(m, 2, s.set().terrain); });
    mass("dMassSetTrimeshTotal", [](dMass *m, CallScene &s) { dMassSetTrimeshTotal(m, 2, s.set().terrain); });
    mass("dMassAdjust", [](dMass *m, CallScene &) { dMassAdjust(m, 3); });
    mass("dMassTranslate", [](dMass *m, CallScene &) { dMassTranslate(m, 0.1, 0.2, 0.3); });
    mass("dMassRotate", [](dMass *m, CallScene &) { dMassRotate(m, kTurn); });
    mass("dMassAdd", [](dMass *m, CallScene &) { dMassAdd(m, m); });
}

void addRotations(CallRecipes &r) {
    const auto rotation = [&](const char *name, void (*change)(dReal *)) {
        r.push_back({name,
                     [change](CallScene &s) {
                         dMatrix3 values{0.1, 0.2, 0.3, 0, 0.5, 0.6, 0.7, 0, 0.9, 0.8, 0.6, 0};
                         change(values);
                         s.tell(values, 3);
                     },
                     nullptr, true});
    };
    rotation("dRSetIdentity", [](dReal *m) { dRSetIdentity(m); });
    rotation("dRFromAxisAndAngle", [](dReal *m) { dRFromAxisAndAngle(m, 1, 2, 3, 0.4); });
    rotation("dRFromEulerAngles", [](dReal *m) { dRFromEulerAngles(m, 0.1, 0.2, 0.3); });
    rotation("dRFrom2Axes", [](dReal *m) { dRFrom2Axes(m, 1, 0.1, 0, 0, 1, 0.2); });
    rotation("dRFromZAxis", [](dReal *m) { dRFromZAxis(m, 0.1, 0.2, 1); });
    rotation("dQSetIdentity", [](dReal *m) { dQSetIdentity(m); });
    rotation("dQFromAxisAndAngle", [](dReal *m) { dQFromAxisAndAngle(m, 1, 2, 3, 0.4); });
    rotation("dQMultiply0", [](dReal *m) { dQMultiply0(m, kTurn, kTurn + 4); });
    rotation("dQMultiply1", [](dReal *m) { dQMultiply1(m, kTurn, kTurn + 4); });
    rotation("dQMultiply2", [](dReal *m) { dQMultiply2(m, kTurn, kTurn + 4); });
    rotation("dQMultiply3", [](dReal *m) { dQMultiply3(m, kTurn, kTurn + 4); });
    rotation("dRfromQ", [](dReal *m) { dRfromQ(m, kTurn); });
    rotation("dQfromR", [](dReal *m) { dQfromR(m, kTurn); });
    rotation("dDQfromW", [](dReal *m) { dDQfromW(m, kTurn, kTurn + 4); });
    rotation("dSafeNormalize3", [](dReal *m) { dSafeNormalize3(m); });
    rotation("dSafeNormalize4", [](dReal *m) { dSafeNormalize4(m); });
    rotation("dNormalize3", [](dReal *m) { dNormalize3(m); });
    rotation("dNormalize4", [](dReal *m) { dNormalize4(m); });
    rotation("dPlaneSpace", [](dReal *m) { dPlaneSpace(kTurn, m, m + 4); });
    rotation("dOrthogonalizeR", [](dReal *m) { dOrthogonalizeR(m); });
}

void addMatrices(CallRecipes &r) {
    // A: 3 x 3, positive definite, rows of four; B: three numbers and more.
    const auto matrix = [&](const char *name, void (*change)(dReal * a, dReal * b, CallScene & s)) {
        r.push_back({name,
                     [change](CallScene &s) {
                         dReal a[16]{4, 1, 0.5, 0, 1, 5, 0.2, 0, 0.5, 0.2, 6}, b[16]{1, 2, 3};
                         change(a, b, s);
                         s.tell(a, 12);
                         s.tell(b, 12);
                     },
                     nullptr, true});
    };
    matrix("dSetZero", [](dReal *a, dReal *, CallScene &) { dSetZero(a, 7); });
    matrix("dSetValue", [](dReal *a, dReal *, CallScene &) { dSetValue(a, 7, 0.3); });
    matrix("dDot", [](dReal *a, dReal *b, CallScene &s) { s.tell(dDot(a, b, 3)); });
    matrix("dMultiply0", [](dReal *a, dReal *b, CallScene &) { dMultiply0(b, a, a, 3, 3, 3); });
    matrix("dMultiply1", [](dReal *a, dReal *b, CallScene &) { dMultiply1(b, a, a, 3, 3, 3); });
    matrix("dMultiply2", [](dReal *a, dReal *b, CallScene &) { dMultiply2(b, a, a, 3, 3, 3); });
    matrix("dFactorCholesky", [](dReal *a, dReal *, CallScene &s) { s.tell(dFactorCholesky(a, 3)); });
    matrix("dSolveCholesky", [](dReal *a, dReal *b, CallScene &) {
        dFactorCholesky(a, 3);
        dSolveCholesky(a, b, 3);
    });
    matrix("dInvertPDMatrix", [](dReal *a, dReal *b, CallScene &s) { s.tell(dInvertPDMatrix(a, b, 3)); });
    matrix("dIsPositiveDefinite", [](dReal *a, dReal *, CallScene &s) { s.tell(dIsPositiveDefinite(a, 3)); });
    matrix("dFactorLDLT", [](dReal *a, dReal *b, CallScene &) { dFactorLDLT(a, b, 3, 4); });
    matrix("dSolveL1", [](dReal *a, dReal *b, CallScene &) { dSolveL1(a, b, 3, 4); });
    matrix("dSolveL1T", [](dReal *a, dReal *b, CallScene &) { dSolveL1T(a, b, 3, 4); });
    matrix("dScaleVector", [](dReal *a, dReal *b, CallScene &) { dScaleVector(a, b, 3); });
    matrix("dVectorScale", [](dReal *a, dReal *b, CallScene &) { dVectorScale(a, b, 3); });
    matrix("dSolveLDLT", [](dReal *a, dReal *b, CallScene &) {
        dReal d[4];
        dFactorLDLT(a, d, 3, 4);
        dSolveLDLT(a, d, b, 3, 4);
    });
    matrix("dLDLTAddTL", [](dReal *a, dReal *b, CallScene &) {
        dReal d[4];
        dFactorLDLT(a, d, 3, 4);
        dLDLTAddTL(a, d, b, 3, 4);
    });
    matrix("dLDLTRemove", [](dReal *a, dReal *b, CallScene &) {
        dReal d[4], copy[16];
        dReal *rows[3] = {copy, copy + 4, copy + 8};
        const int order[3] = {0, 1, 2};
        for (int i = 0; i < 16; ++i) copy[i] = a[i];
        dFactorLDLT(a, d, 3, 4);
        dLDLTRemove(rows, order, a, d, 3, 3, 1, 4);
        for (int i = 0; i < 2; ++i) b[i] = d[i];
    });
    matrix("dRemoveRowCol", [](dReal *a, dReal *, CallScene &) { dRemoveRowCol(a, 3, 4, 1); });
    matrix("dClearUpperTriangle", [](dReal *a, dReal *, CallScene &) { dClearUpperTriangle(a, 3); });
    matrix("dMaxDifference", [](dReal *a, dReal *b, CallScene &s) { s.tell(dMaxDifference(a, b, 3, 3)); });
    matrix("dMaxDifferenceLowerTriangle",
           [](dReal *a, dReal *b, CallScene &s) { s.tell(dMaxDifferenceLowerTriangle(a, b, 3)); });
    matrix("dMakeRandomVector", [](dReal *, dReal *b, CallScene &) { dMakeRandomVector(b, 3, 1); });
    matrix("dMakeRandomMatrix", [](dReal *, dReal *b, CallScene &) { dMakeRandomMatrix(b, 2, 2, 1); });
    matrix("dPrintMatrix", [](dReal *a, dReal *, CallScene &) {
        std::FILE *const file = std::tmpfile();
        dPrintMatrix(a, 2, 2, "%10.4f ", file);
        std::fclose(file);
    });
}

void addTimer(CallRecipes &r) {
    const auto time = [&](const char *name, void (*call)(CallScene &)) {
        r.push_back({name, call, nullptr, true});
    };
    time("dStopwatchReset", [](CallScene &) {
        dStopwatch watch;
        dStopwatchReset(&watch);
    });
    time("dStopwatchStart", [](CallScene &) {
        dStopwatch watch;
        dStopwatchStart(&watch);
    });
    time("dStopwatchStop", [](CallScene &) {
        dStopwatch watch{};
        dStopwatchStop(&watch);
    });
    time("dStopwatchTime", [](CallScene &s) {
        dStopwatch watch{};
        s.tell(dStopwatchTime(&watch));
    });
    time("dTimerStart", [](CallScene &) { dTimerStart("start"); });
    time("dTimerNow", [](CallScene &) { dTimerNow("now"); });
    time("dTimerEnd", [](CallScene &) { dTimerEnd(); });
    time("dTimerReport", [](CallScene &) {
        std::FILE *const file = std::tmpfile();
        dTimerReport(file, 0);
        std::fclose(file);
    });
    time("dTimerTicksPerSecond", [](CallScene &s) { s.tell(dTimerTicksPerSecond() > 0); });
    time("dTimerResolution", [](CallScene &s) { s.tell(dTimerResolution() > 0); });
}

}  // namespace

void addNumberCalls(CallRecipes &recipes) {
    CallRecipes r;
    addMasses(r);
    addRotations(r);
    addMatrices(r);
    addTimer(r);
    for (CallRecipe &recipe : r) {
        recipe.anySpace = true;
        recipes.push_back(std::move(recipe));
    }
}

}  // namespace kept_state

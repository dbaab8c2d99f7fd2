// Recipes for the functions of collision.h that are for height fields.
#include "call_recipes.h"
#include "call_shapes.h"

namespace kept_state {

namespace {

dReal slope(void *, int x, int z) { return 0.1 * x + 0.05 * z; }

const unsigned char *bytes() {
    static unsigned char samples[25];
    for (int i = 0; i < 25; ++i) samples[i] = static_cast<unsigned char>(i * 11 % 7);
    return samples;
}

const short *shorts() {
    static short samples[25];
    for (int i = 0; i < 25; ++i) samples[i] = static_cast<short>(i * 11 % 7);
    return samples;
}

const float *floats() {
    static float samples[25];
    for (int i = 0; i < 25; ++i) samples[i] = 0.1f * static_cast<float>(i * 11 % 7);
    return samples;
}

template <class Build>
CallRecipe::Call build(Build build) {
    return [build](CallScene &s) {
        const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
        build(data);
        dGeomHeightfieldDataSetBounds(data, -1, 2);
        dGeomHeightfieldSetHeightfieldData(s.set().heights, data);
    };
}

// The data that the geom has is rebuilt.
template <class Build>
CallRecipe::Call buildAgain(Build build) {
    return [build](CallScene &s) {
        const dHeightfieldDataID data = dGeomHeightfieldGetHeightfieldData(s.set().heights);
        build(data);
        dGeomHeightfieldSetHeightfieldData(s.set().heights, data);
    };
}

}  // namespace

void addHeightCalls(CallRecipes &r) {
    r.push_back({"dGeomHeightfieldDataCreate",
                 [](CallScene &) { dGeomHeightfieldDataDestroy(dGeomHeightfieldDataCreate()); }});
    r.push_back({"dGeomHeightfieldDataDestroy", [](CallScene &s) {
                     const dHeightfieldDataID old = dGeomHeightfieldGetHeightfieldData(s.set().heights);
                     dGeomHeightfieldSetHeightfieldData(s.set().heights, createHeights(1));
                     dGeomHeightfieldDataDestroy(old);
                 }});
    r.back().inCollision = false;
    r.push_back({"dGeomHeightfieldDataBuildCallback", build([](dHeightfieldDataID data) {
                     dGeomHeightfieldDataBuildCallback(data, nullptr, slope, 3, 3, 5, 5, 1, 0, 0.2, 0);
                 }),
                 buildAgain([](dHeightfieldDataID data) {
                     dGeomHeightfieldDataBuildDouble(data, heightSamples(0), 0, 3, 3, 5, 5, 1, 0, 0.2, 0);
                 })});
    r.push_back({"dGeomHeightfieldDataBuildByte", build([](dHeightfieldDataID data) {
                     dGeomHeightfieldDataBuildByte(data, bytes(), 1, 3, 3, 5, 5, 0.1, 0, 0.2, 0);
                 })});
    r.push_back({"dGeomHeightfieldDataBuildShort", build([](dHeightfieldDataID data) {
                     dGeomHeightfieldDataBuildShort(data, shorts(), 0, 3, 3, 5, 5, 0.1, 0, 0.2, 0);
                 })});
    r.push_back({"dGeomHeightfieldDataBuildSingle", build([](dHeightfieldDataID data) {
                     dGeomHeightfieldDataBuildSingle(data, floats(), 0, 3, 3, 5, 5, 1, 0, 0.2, 1);
                 })});
    r.push_back({"dGeomHeightfieldDataBuildDouble", build([](dHeightfieldDataID data) {
                     dGeomHeightfieldDataBuildDouble(data, heightSamples(1), 0, 3, 3, 5, 5, 1, 0, 0.2, 0);
                 })});
    r.push_back(
        {"dGeomHeightfieldDataSetBounds",
         [](CallScene &s) {
             dGeomHeightfieldDataSetBounds(dGeomHeightfieldGetHeightfieldData(s.set().heights), -2, 0.4);
         },
         [](CallScene &s) {
             dGeomHeightfieldDataSetBounds(dGeomHeightfieldGetHeightfieldData(s.set().heights), -0.5, 1.5);
         }});
    r.push_back(
        {"dGeomHeightfieldSetHeightfieldData",
         [](CallScene &s) { dGeomHeightfieldSetHeightfieldData(s.set().heights, createHeights(1)); },
         [](CallScene &s) { dGeomHeightfieldSetHeightfieldData(s.set().heights, createHeights(0)); }});
    r.push_back({"dGeomHeightfieldGetHeightfieldData",
                 [](CallScene &s) { s.tell(dGeomHeightfieldGetHeightfieldData(s.set().heights) != nullptr); },
                 nullptr, true});
    r.push_back({"dCreateHeightfield",
                 [](CallScene &s) {
                     s.adopt(dCreateHeightfield(s.set().space, createHeights(1), 1));
                     dGeomSetPosition(s.created(), 0.6, 0.5, 0.1);
                 },
                 [](CallScene &s) {
                     const dGeomID geom = s.created();
                     s.drop(geom);
                     dGeomDestroy(geom);
                 }});
}

}  // namespace kept_state

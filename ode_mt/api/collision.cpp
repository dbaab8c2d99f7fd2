// Functions of ode/collision.h: geoms, their classes and colliders, collisions, and the data of height fields.
#include <ode/collision.h>

#include "clusters/dxClusterManager.h"
#include "collision/callbacks/dxConcurrentCallbacks.h"
#include "collision/dxSpaceCollision.h"
#include "collision/narrowphase/boxes/dxBoxBox.h"
#include "collision/narrowphase/dxColliderTable.h"
#include "collision/narrowphase/dxHeightField.h"
#include "collision/narrowphase/dxNarrowphasePrefetch.h"
#include "collision/pairs/dxUnnoticedChanges.h"
#include "collision/spaces/dxOrderedSpace.h"
#include "seams/upstream.h"
#include "settings/dxSettings.h"

namespace {

// Upstream answers these without looking at the table of colliders.
bool isAnsweredEarly(const dxGeom &o1, const dxGeom &o2, int flags) {
    return (flags & NUMC_MASK) == 0 || &o1 == &o2 || (o1.body == o2.body && o1.body != nullptr);
}

bool isUsers(const dxGeom &geom) { return geom.type >= dFirstUserClass; }

// What decides, beside boxes, whether two geoms may meet: their body and their bits. The space that a geom is in keeps its
// pairs and has to hear of a change. So have the spaces around it: a space that holds a geom with a body is dynamic.
void tellFilters(dGeomID geom) {
    for (; geom != nullptr; geom = geom->parent_space)
        if (dxOrderedSpace *const space = dxOrderedSpace::of(geom)) space->filtersChanged(geom);
}

// Upstream's hash space asks which geoms are enabled before the first callback of a call, and callbacks may switch them.
// Upstream answers a NULL.
void tellSwitch(dGeomID geom) {
    dxOrderedSpace *const space = geom != nullptr ? dxOrderedSpace::of(geom) : nullptr;
    if (space != nullptr) space->enabledChanges(geom);
}

// Contacts that are kept for the pair, or are to be; colliders of users, and of height fields.
[[gnu::noinline]] int collideWithCare(dGeomID o1, dGeomID o2, int flags, dContactGeom *contact, int skip) {
    if (dxNarrowphasePrefetch *const ahead = dxNarrowphasePrefetch::current()) {
        const int count = ahead->answer(o1, o2, flags, contact, skip);
        if (count >= 0) return count;
    } else if (dxContactLog *const log = dxContactLog::current()) {
        const bool isValid = o1 != nullptr && o2 != nullptr && contact != nullptr;
        if (isValid && !isAnsweredEarly(*o1, *o2, flags) && dxMayCollideConcurrently(*o1, *o2))
            return log->copies().collide(*o1, *o2, {}, flags, contact, skip);
    }
    const auto collide = [=] { return dxUpstreamCollide(o1, o2, flags, contact, skip); };
    if (o1 == nullptr || o2 == nullptr) return collide();
    if ((isUsers(*o1) || isUsers(*o2)) && !isAnsweredEarly(*o1, *o2, flags))
        dxColliderTable::resolve(o1->type, o2->type);
    return dxIsHeightField(*o1) || dxIsHeightField(*o2) ? dxTransformedGeom::whileTransformed(collide) : collide();
}

}  // namespace

extern "C" {

int dCollide(dGeomID o1, dGeomID o2, int flags, dContactGeom *contact, int skip) {
    const auto isPlain = [](dGeomID geom) { return geom != nullptr && !isUsers(*geom) && !dxIsHeightField(*geom); };
    if (isPlain(o1) && isPlain(o2) && dxNarrowphasePrefetch::current() == nullptr && dxContactLog::current() == nullptr)
        return dxUpstreamCollide(o1, o2, flags, contact, skip);
    return collideWithCare(o1, o2, flags, contact, skip);
}

// Nothing is decided, nor recorded, for the smallest of spaces: it would take longer than the call. Clusters are the broad phase of spaces that
// collide under an algorithm that clusters; a call under another algorithm asks nothing of them, unless the space still has them.
void dSpaceCollide(dSpaceID space, void *data, dNearCallback *callback) {
    dxOrderedSpace *const ordered = callback != nullptr ? dxOrderedSpace::from(space) : nullptr;
    if (ordered == nullptr) return dxUpstreamSpaceCollide(space, data, callback);
    const dxSettings &settings = dxSettings::instance();
    if (settings.algorithm() == dxAlgorithm::Auto && !ordered->isRecorded() && ordered->broadphase() == nullptr)
        return ordered->collide(data, callback);
    if (settings.passName() != nullptr || ordered->broadphase() != nullptr) dxClusterManager::prepare(space, settings.passName());
    dxCollideSpace(*ordered, data, callback);
}

int dBoxBox(const dVector3 p1, const dMatrix3 R1, const dVector3 side1, const dVector3 p2, const dMatrix3 R2, const dVector3 side2,
            dVector3 normal, dReal *depth, int *return_code, int flags, dContactGeom *contact, int skip) {
    const dxBoxPair boxes = {{p1, p2}, {R1, R2}, {side1, side2}};
    const int count = dxBoxBox(boxes, normal, *depth, *return_code, flags, contact, skip);
    return count >= 0 ? count : dxUpstreamBoxBox(p1, R1, side1, p2, R2, side2, normal, depth, return_code, flags, contact, skip);
}

int dCreateGeomClass(const dGeomClass *description) { return dxColliderTable::createClass(description); }

void dSetColliderOverride(int i, int j, dColliderFn *collider) { dxColliderTable::setOverride(i, j, collider); }

void dGeomSetBody(dGeomID geom, dBodyID body) {
    dxUpstreamGeomSetBody(geom, body);
    tellFilters(geom);
}

void dGeomSetCategoryBits(dGeomID geom, unsigned long bits) {
    dxUpstreamGeomSetCategoryBits(geom, bits);
    tellFilters(geom);
}

void dGeomSetCollideBits(dGeomID geom, unsigned long bits) {
    dxUpstreamGeomSetCollideBits(geom, bits);
    tellFilters(geom);
}

void dGeomEnable(dGeomID geom) {
    tellSwitch(geom);
    dxUpstreamGeomEnable(geom);
}

void dGeomDisable(dGeomID geom) {
    tellSwitch(geom);
    dxUpstreamGeomDisable(geom);
}

// Data of height fields: contacts that were computed from it hear of changes (collision/pairs/dxUnnoticedChanges.h), and which data
// is there is known (collision/narrowphase/dxHeightField.h).

dHeightfieldDataID dGeomHeightfieldDataCreate() {
    const dHeightfieldDataID data = dxUpstreamGeomHeightfieldDataCreate();
    dxLiveHeightfields::add(data);
    return data;
}

void dGeomHeightfieldDataBuildCallback(dHeightfieldDataID data, void *userData,
                                       dHeightfieldGetHeight *callback, dReal width, dReal depth,
                                       int widthSamples, int depthSamples, dReal scale, dReal offset,
                                       dReal thickness, int wraps) {
    dxSilentChanges.add();
    dxUpstreamGeomHeightfieldDataBuildCallback(data, userData, callback, width, depth, widthSamples, depthSamples,
                                           scale, offset, thickness, wraps);
}

void dGeomHeightfieldDataBuildByte(dHeightfieldDataID data, const unsigned char *samples, int isCopied,
                                   dReal width, dReal depth, int widthSamples, int depthSamples, dReal scale,
                                   dReal offset, dReal thickness, int wraps) {
    dxSilentChanges.add();
    dxUpstreamGeomHeightfieldDataBuildByte(data, samples, isCopied, width, depth, widthSamples, depthSamples,
                                       scale, offset, thickness, wraps);
}

void dGeomHeightfieldDataBuildShort(dHeightfieldDataID data, const short *samples, int isCopied, dReal width,
                                    dReal depth, int widthSamples, int depthSamples, dReal scale,
                                    dReal offset, dReal thickness, int wraps) {
    dxSilentChanges.add();
    dxUpstreamGeomHeightfieldDataBuildShort(data, samples, isCopied, width, depth, widthSamples, depthSamples,
                                        scale, offset, thickness, wraps);
}

void dGeomHeightfieldDataBuildSingle(dHeightfieldDataID data, const float *samples, int isCopied, dReal width,
                                     dReal depth, int widthSamples, int depthSamples, dReal scale,
                                     dReal offset, dReal thickness, int wraps) {
    dxSilentChanges.add();
    dxUpstreamGeomHeightfieldDataBuildSingle(data, samples, isCopied, width, depth, widthSamples, depthSamples,
                                         scale, offset, thickness, wraps);
}

void dGeomHeightfieldDataBuildDouble(dHeightfieldDataID data, const double *samples, int isCopied,
                                     dReal width, dReal depth, int widthSamples, int depthSamples,
                                     dReal scale, dReal offset, dReal thickness, int wraps) {
    dxSilentChanges.add();
    dxUpstreamGeomHeightfieldDataBuildDouble(data, samples, isCopied, width, depth, widthSamples, depthSamples,
                                         scale, offset, thickness, wraps);
}

void dGeomHeightfieldDataSetBounds(dHeightfieldDataID data, dReal lowest, dReal highest) {
    dxSilentChanges.add();
    dxUpstreamGeomHeightfieldDataSetBounds(data, lowest, highest);
}

void dGeomHeightfieldDataDestroy(dHeightfieldDataID data) {
    dxSilentChanges.add();
    dxLiveHeightfields::remove(data);
    dxUpstreamGeomHeightfieldDataDestroy(data);
}

}  // extern "C"

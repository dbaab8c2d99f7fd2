// Data of height fields (ode/collision.h): contacts that were computed from it hear of changes
// (collision/dxSilentChanges.h), and which data is there is known (collision/dxLivingHeights.h). Upstream's own functions
// are renamed by the seam ode/seams/heightfield.h.
#include <ode/collision.h>

#include "collision/dxLivingHeights.h"
#include "collision/dxSilentChanges.h"

namespace {

// The samples as they are stored, and how they are laid out: what all kinds of data have in common.
template <class Samples>
using Build = void(dHeightfieldDataID data, const Samples *samples, int isCopied, dReal width, dReal depth,
                   int widthSamples, int depthSamples, dReal scale, dReal offset, dReal thickness, int wraps);

}  // namespace

extern "C" {
dHeightfieldDataID dxUpstreamHeightfieldDataCreate();
Build<unsigned char> dxUpstreamHeightfieldDataBuildByte;
Build<short> dxUpstreamHeightfieldDataBuildShort;
Build<float> dxUpstreamHeightfieldDataBuildSingle;
Build<double> dxUpstreamHeightfieldDataBuildDouble;
void dxUpstreamHeightfieldDataBuildCallback(dHeightfieldDataID data, void *userData,
                                            dHeightfieldGetHeight *callback, dReal width, dReal depth,
                                            int widthSamples, int depthSamples, dReal scale, dReal offset,
                                            dReal thickness, int wraps);
void dxUpstreamHeightfieldDataSetBounds(dHeightfieldDataID data, dReal lowest, dReal highest);
void dxUpstreamHeightfieldDataDestroy(dHeightfieldDataID data);

dHeightfieldDataID dGeomHeightfieldDataCreate() {
    const dHeightfieldDataID data = dxUpstreamHeightfieldDataCreate();
    dxLivingHeights::add(data);
    return data;
}

void dGeomHeightfieldDataBuildCallback(dHeightfieldDataID data, void *userData,
                                       dHeightfieldGetHeight *callback, dReal width, dReal depth,
                                       int widthSamples, int depthSamples, dReal scale, dReal offset,
                                       dReal thickness, int wraps) {
    dxSilentChanges::add();
    dxUpstreamHeightfieldDataBuildCallback(data, userData, callback, width, depth, widthSamples, depthSamples,
                                           scale, offset, thickness, wraps);
}

void dGeomHeightfieldDataBuildByte(dHeightfieldDataID data, const unsigned char *samples, int isCopied,
                                   dReal width, dReal depth, int widthSamples, int depthSamples, dReal scale,
                                   dReal offset, dReal thickness, int wraps) {
    dxSilentChanges::add();
    dxUpstreamHeightfieldDataBuildByte(data, samples, isCopied, width, depth, widthSamples, depthSamples,
                                       scale, offset, thickness, wraps);
}

void dGeomHeightfieldDataBuildShort(dHeightfieldDataID data, const short *samples, int isCopied, dReal width,
                                    dReal depth, int widthSamples, int depthSamples, dReal scale,
                                    dReal offset, dReal thickness, int wraps) {
    dxSilentChanges::add();
    dxUpstreamHeightfieldDataBuildShort(data, samples, isCopied, width, depth, widthSamples, depthSamples,
                                        scale, offset, thickness, wraps);
}

void dGeomHeightfieldDataBuildSingle(dHeightfieldDataID data, const float *samples, int isCopied, dReal width,
                                     dReal depth, int widthSamples, int depthSamples, dReal scale,
                                     dReal offset, dReal thickness, int wraps) {
    dxSilentChanges::add();
    dxUpstreamHeightfieldDataBuildSingle(data, samples, isCopied, width, depth, widthSamples, depthSamples,
                                         scale, offset, thickness, wraps);
}

void dGeomHeightfieldDataBuildDouble(dHeightfieldDataID data, const double *samples, int isCopied,
                                     dReal width, dReal depth, int widthSamples, int depthSamples,
                                     dReal scale, dReal offset, dReal thickness, int wraps) {
    dxSilentChanges::add();
    dxUpstreamHeightfieldDataBuildDouble(data, samples, isCopied, width, depth, widthSamples, depthSamples,
                                         scale, offset, thickness, wraps);
}

void dGeomHeightfieldDataSetBounds(dHeightfieldDataID data, dReal lowest, dReal highest) {
    dxSilentChanges::add();
    dxUpstreamHeightfieldDataSetBounds(data, lowest, highest);
}

void dGeomHeightfieldDataDestroy(dHeightfieldDataID data) {
    dxSilentChanges::add();
    dxLivingHeights::remove(data);
    dxUpstreamHeightfieldDataDestroy(data);
}

}  // extern "C"

// Ground on a square grid: the same heights as a triangle mesh, z up, or as a height field, turned so that
// its y axis points up. Both are centred at their geom's position.
#pragma once

#include "order_sum.h"

#include <ode/ode.h>

#include <functional>
#include <vector>

namespace exactness {

struct Ground {
    int samples;                                // along each side
    dReal pitch;                                // m, between two samples
    std::function<dReal(int x, int y)> height;  // m

    dReal side() const { return pitch * (samples - 1); }  // m
};

// Waves about one metre high.
dReal waves(int x, int y);

class GridMesh {
public:
    explicit GridMesh(Ground ground);
    ~GridMesh() { dGeomTriMeshDataDestroy(m_data); }
    GridMesh(const GridMesh &) = delete;
    GridMesh &operator=(const GridMesh &) = delete;

    dTriMeshDataID data() const { return m_data; }
    void reshape(const std::function<dReal(int x, int y)> &height);

private:
    void addSquare(dTriIndex corner);

    Ground m_ground;
    std::vector<dReal> m_corners;
    std::vector<dTriIndex> m_faces;
    dTriMeshDataID m_data;
};

enum class HeightSource { Callback, Bytes, Shorts, Floats, Doubles };

struct HeightOptions {
    HeightSource source = HeightSource::Doubles;
    bool repeats = false;
    dReal thickness = 2;   // m, below the lowest height
    dReal scale = 1;       // of the numbers stored
    dReal offset = 0;      // m
    bool isCopied = true;  // else the library reads the grid's own numbers
};

class HeightGrid {
public:
    HeightGrid(Ground ground, const HeightOptions &options);
    ~HeightGrid() { dGeomHeightfieldDataDestroy(m_data); }
    HeightGrid(const HeightGrid &) = delete;
    HeightGrid &operator=(const HeightGrid &) = delete;

    dGeomID createGeom(dSpaceID space) const;
    void reshape(const std::function<dReal(int x, int y)> &height);  // of a grid that is not copied
    void rebuild(const std::function<dReal(int x, int y)> &height);  // of any
    const OrderSum &heightsAsked() const { return m_asked; }         // of the callback

private:
    static dReal callback(void *grid, int x, int z);
    void fill();
    void build();

    Ground m_ground;
    HeightOptions m_options;
    std::vector<unsigned char> m_bytes;
    std::vector<short> m_shorts;
    std::vector<float> m_floats;
    std::vector<double> m_doubles;
    OrderSum m_asked;
    dHeightfieldDataID m_data;
};

}  // namespace exactness

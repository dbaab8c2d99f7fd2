// The geometry of a geom, in its own axes; equal shapes share one.
import {
    BoxBufferGeometry, BufferGeometry, CylinderBufferGeometry, Float32BufferAttribute, LatheBufferGeometry, Matrix4, PlaneBufferGeometry,
    Quaternion, SphereBufferGeometry, Vector2, Vector3,
} from 'three';

const kSides = 24, kQuarterTurn = Math.PI / 2, kHalfCircle = 8;

// Of a capsule: two quarter circles, which a lathe turns around.
function profile(radius, length) {
    const points = [];
    for (const end of [-1, 1])
        for (let i = 0; i <= kHalfCircle; ++i) {
            const angle = end < 0 ? -kQuarterTurn + kQuarterTurn * i / kHalfCircle : kQuarterTurn * i / kHalfCircle;
            points.push(new Vector2(radius * Math.cos(angle), radius * Math.sin(angle) + end * length / 2));
        }
    return points;
}

function meshOf(triangles) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(triangles.flat(2), 3));
    geometry.computeVertexNormals();
    return geometry;
}

// ODE's capsules and cylinders lie along z, those of three.js along y.
const makers = {
    box: ([x, y, z]) => new BoxBufferGeometry(x, y, z),
    bounds: ([x, y, z]) => new BoxBufferGeometry(x, y, z),
    sphere: ([radius]) => new SphereBufferGeometry(radius, kSides, kSides / 2),
    capsule: ([radius, length]) => new LatheBufferGeometry(profile(radius, length), kSides).rotateX(kQuarterTurn),
    cylinder: ([radius, length]) => new CylinderBufferGeometry(radius, radius, length, kSides).rotateX(kQuarterTurn),
    mesh: ([x0, y0, z0, x1, y1, z1]) =>
        new BoxBufferGeometry(x1 - x0, y1 - y0, z1 - z0).translate((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2),
};

// A square around the point of the plane that is nearest to what moves.
function planeOf([a, b, c, d], centre, halfEdge) {
    const normal = new Vector3(a, b, c);
    const foot = centre.clone().addScaledVector(normal, d - normal.dot(centre));
    return new PlaneBufferGeometry(2 * halfEdge, 2 * halfEdge)
        .applyMatrix(new Matrix4().compose(foot, new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), normal), new Vector3(1, 1, 1)));
}

export class Shapes {
    // Planes reach from the centre of what moves to `halfEdge`.
    constructor(centre, halfEdge) {
        this.known = new Map();
        this.centre = centre;
        this.halfEdge = halfEdge;
    }

    of({ shape, size, triangles }) {
        if (triangles) return meshOf(triangles);
        const key = shape + size.join();
        if (!this.known.has(key))
            this.known.set(key, shape === 'plane' ? planeOf(size, this.centre, this.halfEdge) : makers[shape](size));
        return this.known.get(key);
    }
}

// Shapes of which only the extent is known.
export function isOutline({ shape, triangles }) {
    return shape === 'bounds' || (shape === 'mesh' && !triangles);
}

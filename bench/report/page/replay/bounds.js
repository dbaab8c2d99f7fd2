// Where the things are that move, over all frames: what the camera looks at.
import { Box3, Matrix4, Quaternion, Vector3 } from 'three';
import { Shapes } from './shapes.js';

const kFramesLookedAt = 20, kLeastRadius = 0.1;

function matrixOf([x, y, z, qw, qx, qy, qz]) {
    return new Matrix4().compose(new Vector3(x, y, z), new Quaternion(qx, qy, qz, qw), new Vector3(1, 1, 1));
}

// Returns the box of each geom in its own axes; null: a plane, which has no end.
function localBoxes({ geoms }) {
    const shapes = new Shapes();
    return geoms.map(geom => {
        if (geom.shape === 'plane') return null;
        const geometry = shapes.of(geom);
        geometry.computeBoundingBox();
        return geometry.boundingBox;
    });
}

// Some of the frames, the first and the last one among them.
function framesLookedAt(frames) {
    const stride = Math.max(1, Math.floor(frames.length / kFramesLookedAt));
    return frames.filter((_, i) => i % stride === 0 || i === frames.length - 1);
}

// How far from a point a corner of a box is.
function reachOf({ min, max }, centre) {
    const farthest = ['x', 'y', 'z'].map(axis => Math.max(Math.abs(min[axis] - centre[axis]), Math.abs(max[axis] - centre[axis])));
    return Math.hypot(...farthest);
}

export function boundsOfMotion({ header, frames }) {
    const locals = localBoxes(header), box = new Box3();
    const boxOf = (frame, i) => locals[i].clone().applyMatrix4(matrixOf(frame.geoms[i]));
    for (const frame of framesLookedAt(frames)) {
        for (const [x, y, z] of frame.bodies) box.expandByPoint(new Vector3(x, y, z));  // a body need not have a geom
        header.geoms.forEach(({ body }, i) => { if (body >= 0 && locals[i]) box.union(boxOf(frame, i)); });
    }
    if (box.isEmpty()) box.expandByPoint(new Vector3());
    const centre = box.getCenter(new Vector3()), radius = Math.max(kLeastRadius, box.getSize(new Vector3()).length() / 2);
    const reaches = header.geoms.map((_, i) => locals[i] ? reachOf(boxOf(frames[0], i), centre) : 0);
    return { centre, radius, reach: reaches.reduce((most, reach) => Math.max(most, reach), radius) };
}

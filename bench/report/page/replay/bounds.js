// Where the things are that move, over all frames: what the camera looks at.
import { Box3, Vector3 } from 'three';

const kFramesLookedAt = 20, kLeastRadius = 0.1;

// How far from a point the middles of all geoms are.
function reachOf({ header, frames }, centre) {
    const distances = frames[0].geoms.filter((_, i) => header.geoms[i].shape !== 'plane')
        .map(([x, y, z]) => centre.distanceTo(new Vector3(x, y, z)));
    return distances.reduce((most, distance) => Math.max(most, distance), 0);
}

export function boundsOfMotion(recording) {
    const { frames } = recording;
    const box = new Box3();
    const stride = Math.max(1, Math.floor(frames.length / kFramesLookedAt));
    for (let i = 0; i < frames.length; i += stride)
        for (const [x, y, z] of frames[i].bodies) box.expandByPoint(new Vector3(x, y, z));
    if (box.isEmpty()) box.expandByPoint(new Vector3());
    const centre = box.getCenter(new Vector3()), radius = Math.max(kLeastRadius, box.getSize(new Vector3()).length() / 2);
    return { centre, radius, reach: Math.max(radius, reachOf(recording, centre)) };
}

// Where two recordings of one world differ first: in which frame, body and number.
import { bodyText } from './recording.js';

const kPose = ['position x', 'position y', 'position z', 'quaternion w', 'quaternion x', 'quaternion y', 'quaternion z'];
const kVelocity = ['velocity x', 'velocity y', 'velocity z', 'angular velocity x', 'angular velocity y', 'angular velocity z'];

// Bits are compared, as -0 and 0 differ; JSON keeps all digits of a number.
function differingField(one, other, names) {
    const found = names.findIndex((_, i) => !Object.is(one[i], other[i]));
    return found < 0 ? null : { field: names[found], values: [one[found], other[found]] };
}

function differenceInFrame(one, other) {
    if (one.bodies.length !== other.bodies.length)
        return { body: null, field: 'number of bodies', values: [one.bodies.length, other.bodies.length] };
    for (let body = 0; body < one.bodies.length; ++body) {
        const found = differingField(one.bodies[body], other.bodies[body], kPose) ??
            (one.velocities && other.velocities && differingField(one.velocities[body], other.velocities[body], kVelocity)) ??
            (one.awake && other.awake && differingField([one.awake[body]], [other.awake[body]], ['awake']));
        if (found) return { body, ...found };
    }
    return null;
}

// Returns { compared, first }: the number of frames that both have, and { frame, body, field, values } or null.
export function compareRecordings(one, other) {
    let compared = 0;
    for (const frame of one.frames) {
        const twin = other.byNumber.get(frame.number);
        if (!twin) continue;
        ++compared;
        const found = differenceInFrame(frame, twin);
        if (found) return { compared, first: { frame: frame.number, ...found } };
    }
    return { compared, first: null };
}

// Returns whether this body is elsewhere, turned otherwise or at another speed in the two frames.
export function bodyDiffers(one, other, body) {
    return Boolean(differingField(one.bodies[body], other.bodies[body] ?? [], kPose) ?? (one.velocities && other.velocities &&
        differingField(one.velocities[body], other.velocities[body] ?? [], kVelocity)));
}

// `recording`: one of the two, with the names of the bodies.
export function differenceText({ compared, first }, recording) {
    if (compared === 0) return 'The recordings have no frames in common.';
    if (!first) return `Equal in all ${compared} frames that both have: every position, orientation and velocity, in every bit.`;
    const where = first.body === null ? '' : ` of ${bodyText(recording, first.body)}`;
    const [left, right] = first.values;
    return `First difference in frame ${first.frame}: ${first.field}${where} is ${left} on the left, ${right} on the right.`;
}

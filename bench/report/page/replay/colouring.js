// What the colours of geoms say.
import { Color } from 'three';
import { kNeutral } from '../palette.js';
import { colourOf, ofGeom } from './cluster_colours.js';

const kAsleep = '#56789a', kAwake = '#e69f00', kSame = '#9aa0a6', kOther = '#d55e00';
const neutral = new Color(kNeutral);

// Each gives the colour of geom `i` of a frame of a recording; its body is `body` (-1: static).
export const kColourings = {
    body: {
        text: 'body', needs: null, meaning: 'one colour for each body; grey: static',
        of: (recording, frame, i, body) => body < 0 ? neutral : colourOf(body),
    },
    cluster: {
        text: 'cluster', needs: 'clusters',
        meaning: 'strong: moves; white: big, in no cluster; pale: static, in a cluster or listed by it; grey: tested with all',
        of: (recording, frame, i, body) => ofGeom(recording, frame.memberships[i], body < 0),
    },
    island: {
        text: 'island', needs: 'islands', meaning: 'one colour for each island of the step; grey: asleep, or static',
        of: (recording, frame, i, body) => body < 0 || frame.islands[body] < 0 ? neutral : colourOf(frame.islands[body]),
    },
    thread: {
        text: 'thread', needs: 'threads',
        meaning: 'one colour for each thread that stepped the body; blue: the one that called the step, also for islands that several step together; grey: asleep, or static',
        of: (recording, frame, i, body) => body < 0 || frame.workers[body] < 0 ? neutral : colourOf(frame.workers[body]),
    },
    sleep: {
        text: 'sleep', needs: 'sleep', meaning: 'orange: awake; blue: asleep (disabled); grey: static',
        of: (recording, frame, i, body) => body < 0 ? neutral : new Color(frame.awake[body] ? kAwake : kAsleep),
    },
};

// Of two recordings: which bodies differ from their twins.
export const kDifferenceColours = { same: new Color(kSame), other: new Color(kOther) };

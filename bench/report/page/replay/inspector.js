// The body that was picked: where it is, how fast, in which cluster and island; in each recording.
import { element, table } from '../elements.js';
import { bodyText, titleOf } from './recording.js';

const kUnknown = 'not recorded';

function capitalised(words) {
    return words[0].toUpperCase() + words.slice(1);
}

function text(values) {
    return values ? values.map(value => Number(value).toPrecision(9)).join(', ') : kUnknown;
}

function islandText(island) {
    return island < 0 ? 'none' : String(island);
}

function threadText(worker) {
    return worker < 0 ? 'none' : worker === 0 ? '0, which called the step' : String(worker);
}

function rows(frame, body) {
    if (!frame?.bodies[body]) return [frame ? 'no such body' : 'no such frame', '', '', '', '', '', '', ''];
    const [x, y, z, ...turn] = frame.bodies[body];
    const velocity = frame.velocities?.[body];
    return [text([x, y, z]), text(turn), text(velocity?.slice(0, 3)), text(velocity?.slice(3)),
        String(frame.bodyClusters[body] || 'none'), frame.islands ? islandText(frame.islands[body]) : kUnknown,
        frame.workers ? threadText(frame.workers[body]) : kUnknown,
        frame.awake ? (frame.awake[body] ? 'awake' : 'asleep') : kUnknown];
}

const kNames = ['position, m', 'quaternion w, x, y, z', 'velocity, m/s', 'angular velocity, rad/s', 'cluster', 'island', 'thread', 'sleep'];

export class Inspector {
    constructor(recordings) {
        this.recordings = recordings;
        this.element = element('div', { class: 'inspector' });
    }

    // `frames`: one of each recording; null: it has none of that number.
    show(body, frames) {
        if (body === null) {
            this.element.replaceChildren(element('p', { class: 'note' }, 'No body is picked: click one, or press N.'));
            return;
        }
        const columns = frames.map(frame => rows(frame, body));
        this.element.replaceChildren(table(capitalised(bodyText(this.recordings[0], body)), ['', ...this.recordings.map(titleOf)],
            kNames.map((name, i) => [name, ...columns.map(column => column[i])])));
    }
}

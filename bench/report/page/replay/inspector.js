// The body that was picked: where it is, how fast, in which cluster and island; in each recording.
import { element, table } from '../elements.js';

const kUnknown = 'not recorded';

function text(values) {
    return values ? values.map(value => Number(value).toPrecision(9)).join(', ') : kUnknown;
}

function islandText(island) {
    return island < 0 ? 'none' : String(island);
}

function rows(frame, body) {
    if (!frame?.bodies[body]) return [frame ? 'no such body' : 'no such frame', '', '', '', '', '', ''];
    const [x, y, z, ...turn] = frame.bodies[body];
    const velocity = frame.velocities?.[body];
    return [text([x, y, z]), text(turn), text(velocity?.slice(0, 3)), text(velocity?.slice(3)),
        String(frame.bodyClusters[body] || 'none'), frame.islands ? islandText(frame.islands[body]) : kUnknown,
        frame.awake ? (frame.awake[body] ? 'awake' : 'asleep') : kUnknown];
}

const kNames = ['position, m', 'quaternion w, x, y, z', 'velocity, m/s', 'angular velocity, rad/s', 'cluster', 'island', 'sleep'];

export class Inspector {
    constructor(titles) {
        this.titles = titles;
        this.element = element('div', { class: 'inspector' });
    }

    // `frames`: one of each recording; null: it has none of that number.
    show(body, frames) {
        if (body === null) {
            this.element.replaceChildren(element('p', { class: 'note' }, 'No body is picked: click one, or press N.'));
            return;
        }
        const columns = frames.map(frame => rows(frame, body));
        this.element.replaceChildren(table(`Body ${body}`, ['', ...this.titles],
            kNames.map((name, i) => [name, ...columns.map(column => column[i])])));
    }
}

// The slider of the frames, with marks above it: merges and splits of clusters, and the first difference.
import { element, table } from '../elements.js';
import { themeColour } from '../palette.js';

const kMerge = '#0072b2', kSplit = '#e69f00', kHeight = 26;

function counts(frame) {
    const splits = frame.events.filter(event => event.kind === 'split').length;
    return { merges: frame.events.length - splits, splits };
}

export class Timeline {
    constructor(recording, difference, onScrub) {
        const { frames } = recording;
        this.frames = frames;
        this.difference = difference;
        this.slider = element('input', { id: 'replay-frame', type: 'range', min: 0, max: frames.length - 1, value: 0,
            oninput: () => onScrub(Number(this.slider.value)) });
        this.marks = element('canvas', { height: kHeight, 'aria-hidden': 'true' });
        this.label = element('output', { for: 'replay-frame' });
        this.element = element('div', { class: 'timeline' }, this.marks,
            element('label', { for: 'replay-frame' }, 'Frame '), this.slider, this.label, this.legend());
    }

    legend() {
        const found = this.frames.map(frame => [frame, counts(frame)]).filter(([, { merges, splits }]) => merges + splits > 0);
        if (found.length === 0) return element('p', { class: 'note' }, 'No merges or splits of clusters are recorded.');
        return element('details', {}, element('summary', {}, 'Merges (blue, upwards) and splits (orange, downwards) of clusters'),
            table('Merges and splits since the recorded frame before', ['frame', 'merges', 'splits'],
                found.map(([frame, { merges, splits }]) => [String(frame.number), String(merges), String(splits)])));
    }

    show(place) {
        const frame = this.frames[place];
        this.slider.value = place;
        this.slider.setAttribute('aria-valuetext', `frame ${frame.number}, ${frame.time.toFixed(3)} seconds`);
        this.label.textContent = ` ${frame.number} (${frame.time.toFixed(3)} s)`;
    }

    draw() {
        const width = this.marks.width = this.marks.clientWidth, context = this.marks.getContext('2d');
        const inset = 8, at = place => inset + (width - 2 * inset) * place / Math.max(1, this.frames.length - 1);
        const all = this.frames.map(counts), most = Math.max(1, ...all.map(({ merges, splits }) => Math.max(merges, splits)));
        context.clearRect(0, 0, width, kHeight);
        all.forEach(({ merges, splits }, place) => {
            context.fillStyle = kMerge;
            context.fillRect(at(place) - 1, kHeight / 2, 2, -kHeight / 2 * merges / most);
            context.fillStyle = kSplit;
            context.fillRect(at(place) - 1, kHeight / 2, 2, kHeight / 2 * splits / most);
        });
        if (!this.difference) return;
        const place = this.frames.findIndex(frame => frame.number === this.difference.frame);
        context.fillStyle = themeColour('--warning');
        context.fillRect(at(place) - 2, 0, 4, kHeight);
    }
}

// How frame times are distributed: share of frames over time, and what share of frames takes no longer.
import { choice, section, table } from '../elements.js';
import { milliseconds } from '../numbers.js';
import { colour, dash } from '../palette.js';
import { axis, plot } from './plot.js';

const kShares = [[0.05, '5 %'], [0.25, '25 %'], [0.5, 'median'], [0.75, '75 %'], [0.95, '95 %'], [0.99, '99 %'], [1, 'longest']];

// The middle of the bin, in seconds, below whose end a share of the frames lies: exact to half a bin.
export function quantile({ seconds, frames, binsPerDoubling }, share) {
    const total = frames.reduce((sum, count) => sum + count, 0);
    let below = 0;
    for (let i = 0; i < frames.length; ++i) {
        below += frames[i];
        if (below >= share * total) return seconds[i] * 2 ** (0.5 / binsPerDoubling);
    }
    return null;
}

function dataSet(engine, index) {
    const { seconds, frames, binsPerDoubling } = engine.frameTimes;
    const total = frames.reduce((sum, count) => sum + count, 0), middle = 2 ** (0.5 / binsPerDoubling);
    return {
        label: engine.engine,
        data: seconds.map((second, i) => ({ x: 1000 * second * middle, y: 100 * frames[i] / total })),
        borderColor: colour(index),
        backgroundColor: colour(index),
        borderDash: dash(index),
        borderWidth: 2,
        pointRadius: 2,
    };
}

function configuration(engines) {
    return {
        type: 'line',
        data: { datasets: engines.map(dataSet) },
        options: {
            scales: { x: axis('milliseconds for a frame', { type: 'logarithmic' }), y: axis('% of the frames', { beginAtZero: true }) },
        },
    };
}

export function showFrameTimes({ worlds }) {
    const known = worlds.map(world => [world.world, world.engines.filter(engine => engine.frameTimes?.frames.length > 0)])
        .filter(([, engines]) => engines.length > 0);
    if (known.length === 0) return;
    const made = section('frame-times', 'Distribution of frame times');
    const show = name => {
        const engines = known.find(([world]) => world === name)[1];
        draw(configuration(engines), `Lines: share of frames over their time in ${name}, one line for each engine.`,
            table(`${name}: milliseconds that this share of the frames does not exceed`, ['engine', ...kShares.map(([, text]) => text)],
                engines.map(engine => [engine.engine, ...kShares.map(([share]) => milliseconds(quantile(engine.frameTimes, share)))])));
    };
    made.append(choice('World', 'frame-times-world', known.map(([world]) => [world, world]), show));
    const draw = plot(made, 'Share of the frames in bins that are 9 % wide. Warm-up is not counted.');
    show(known[0][0]);
}

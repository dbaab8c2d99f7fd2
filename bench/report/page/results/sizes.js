// How time grows with the size of a world; both axes are logarithmic, so that a power is a straight line.
import { element, section, table } from '../elements.js';
import { milliseconds, number } from '../numbers.js';
import { colour, dash, mark } from '../palette.js';
import { axis, plot } from './plot.js';

const kParts = ['frame', 'collision'];

function dataSet(curve, engine, index, part) {
    return {
        label: engine.engine,
        data: curve.sizes.map((size, i) => ({ x: size, y: engine.parts[part].meanSeconds[i] }))
            .filter(({ y }) => y !== null).map(({ x, y }) => ({ x, y: 1000 * y })),
        borderColor: colour(index),
        backgroundColor: colour(index),
        borderDash: dash(index),
        pointStyle: mark(index),
        pointRadius: 5,
    };
}

function configuration(curve, part) {
    return {
        type: 'line',
        data: { datasets: curve.engines.map((engine, i) => dataSet(curve, engine, i, part)) },
        options: {
            scales: {
                x: axis(`size N of ${curve.world}`, { type: 'logarithmic' }),
                y: axis(`${part}, milliseconds`, { type: 'logarithmic' }),
            },
        },
    };
}

function numbers(curve, part) {
    return table(`${curve.world}: milliseconds (${part}), and the power of the size that they grow with`,
        ['N', ...curve.engines.flatMap(engine => [engine.engine, 'growth'])],
        curve.sizes.map((size, i) => [String(size), ...curve.engines.flatMap(engine =>
            [milliseconds(engine.parts[part].meanSeconds[i]), number(engine.parts[part].growth[i])])]));
}

export function showSizes({ curves }) {
    if (!curves || curves.length === 0) return;
    const made = section('sizes', 'Scaling over size');
    for (const curve of curves) {
        made.append(element('h3', {}, curve.world));
        for (const part of kParts)
            plot(made, 'Mean time of a frame; both axes are logarithmic.')(configuration(curve, part),
                `Lines: milliseconds (${part}) over the size of ${curve.world}, one line for each engine.`, numbers(curve, part));
    }
}

// How the speed-up grows with the number of threads.
import { element, section, table } from '../elements.js';
import { spread } from '../numbers.js';
import { colour, dash, mark } from '../palette.js';
import { axis, plot } from './plot.js';
import { engineNames, speedUp, threadFamilies } from './runs.js';

function dataSet(world, points, index) {
    const spreads = points.map(([, name]) => speedUp(world, name, 'frame'));
    return {
        label: world.world,
        data: spreads.map(found => found?.median ?? null),
        whiskers: spreads.map(found => found && [found.lowerQuartile, found.upperQuartile]),
        borderColor: colour(index),
        backgroundColor: colour(index),
        borderDash: dash(index),
        pointStyle: mark(index),
        pointRadius: 5,
        spreads,
    };
}

function configuration(worlds, points, reference) {
    return {
        type: 'line',
        data: { labels: points.map(([threads]) => String(threads)), datasets: worlds.map((world, i) => dataSet(world, points, i)) },
        options: {
            scales: { x: axis('threads (0: serial)'), y: axis(`speed-up of the frame over ${reference}`, { beginAtZero: true }) },
            plugins: { tooltip: { callbacks: { label: ({ dataset, dataIndex: i }) => `${dataset.label}: ${spread(dataset.spreads[i])}` } } },
        },
    };
}

export function showThreads({ worlds }) {
    const families = threadFamilies(engineNames(worlds));
    if (families.length === 0) return;
    const reference = worlds[0].engines[0].engine;
    const made = section('threads', 'Scaling over threads');
    for (const [family, points] of families) {
        made.append(element('h3', {}, family));
        plot(made, 'Median of the rounds; whiskers: quartiles.')(configuration(worlds, points, reference),
            `Lines: speed-up of the frame over the number of threads, one line for each world, engines ${family}.`,
            table(`Speed-up of the frame by threads, ${family}: median [lower quartile, upper quartile]`,
                ['world', ...points.map(([threads]) => String(threads))],
                worlds.map(world => [world.world, ...points.map(([, name]) => spread(speedUp(world, name, 'frame')))])));
    }
}

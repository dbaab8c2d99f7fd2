// Speed-ups over the first engine: median of the rounds, quartiles as whiskers.
import { choice, section, table } from '../elements.js';
import { milliseconds, spread } from '../numbers.js';
import { colour } from '../palette.js';
import { axis, plot } from './plot.js';
import { engineNames, engineOf, partsOf, speedUp } from './runs.js';

function dataSet(worlds, name, index, part) {
    const spreads = worlds.map(world => speedUp(world, name, part));
    return {
        label: name,
        data: spreads.map(found => found?.median ?? null),
        whiskers: spreads.map(found => found && [found.lowerQuartile, found.upperQuartile]),
        backgroundColor: colour(index),
        spreads,
    };
}

function configuration(worlds, names, part, reference) {
    return {
        type: 'bar',
        data: { labels: worlds.map(world => world.world), datasets: names.map((name, i) => dataSet(worlds, name, i, part)) },
        options: {
            scales: { y: axis(`speed-up over ${reference}`, { beginAtZero: true }), x: axis('world') },
            plugins: { tooltip: { callbacks: { label: ({ dataset, dataIndex: i }) => `${dataset.label}: ${spread(dataset.spreads[i])}` } } },
        },
    };
}

function numbers(worlds, names, part, meaning) {
    return table(`Speed-up, ${meaning}: median [lower quartile, upper quartile]; and mean milliseconds`,
        ['world', ...names.flatMap(name => [name, 'ms'])],
        worlds.map(world => [world.world, ...names.flatMap(name => [spread(speedUp(world, name, part)),
            milliseconds(engineOf(world, name)?.parts?.[part]?.meanSeconds)])]));
}

export function showSpeedUps({ worlds }) {
    const names = engineNames(worlds), parts = partsOf(worlds), reference = worlds[0].engines[0].engine;
    const made = section('speed-ups', 'Speed-ups');
    const show = part => {
        const meaning = parts.find(([name]) => name === part)[1];
        draw(configuration(worlds, names, part, reference), `Bars: speed-up of each engine in each world, ${meaning}.`,
            numbers(worlds, names, part, meaning));
    };
    made.append(choice('Part of the frame', 'speed-ups-part', parts, show));
    const draw = plot(made, `Time of ${reference} divided by the engine's own in the same round. Whiskers: quartiles. Above 1 is faster.`);
    show(parts[0][0]);
}

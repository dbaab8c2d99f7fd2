// Simulated seconds in a second of wall-clock time.
import { section, table } from '../elements.js';
import { number, spread } from '../numbers.js';
import { colour } from '../palette.js';
import { axis, plot } from './plot.js';
import { engineNames, engineOf } from './runs.js';

function dataSet(worlds, name, index) {
    const engines = worlds.map(world => engineOf(world, name));
    return {
        label: name,
        data: engines.map(engine => engine?.realTimeFactor ?? null),
        whiskers: engines.map(engine => engine?.realTimeSamples?.count > 0
            ? [engine.realTimeSamples.quantiles.lowerQuartile, engine.realTimeSamples.quantiles.upperQuartile] : null),
        backgroundColor: colour(index),
    };
}

export function showRealTime({ worlds }) {
    const names = engineNames(worlds);
    const made = section('real-time', 'Real-time factor');
    const draw = plot(made, 'Simulated seconds in a second of wall-clock time, over the whole run; whiskers: quartiles of its seconds, ' +
        'if it ran for so long.');
    draw({
        type: 'bar',
        data: { labels: worlds.map(world => world.world), datasets: names.map((name, i) => dataSet(worlds, name, i)) },
        options: { scales: { x: axis('world'), y: axis('× real time', { type: 'logarithmic' }) } },
    }, 'Bars: real-time factor of each engine in each world.',
    table('Real-time factor of the run; in brackets that of single seconds: median [lower quartile, upper quartile]',
        ['world', ...names],
        worlds.map(world => [world.world, ...names.map(name => {
            const engine = engineOf(world, name);
            if (!engine) return '–';
            const seconds = engine.realTimeSamples?.count > 0 ? ` (${spread(engine.realTimeSamples.quantiles)})` : '';
            return number(engine.realTimeFactor) + seconds;
        })])));
}

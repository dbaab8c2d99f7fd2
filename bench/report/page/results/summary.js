// One sentence in plain words for each world, and what was run.
import { element, section, table } from '../elements.js';
import { number, percent } from '../numbers.js';
import { engineNames, speedUp } from './runs.js';

const kSame = ['reference', 'same'];

function fastest(world) {
    const first = world.engines[0].engine;
    return world.engines.filter(engine => engine.engine !== first && !engine.failure)
        .map(engine => [engine, speedUp(world, engine.engine, 'frame')?.median ?? 0])
        .sort(([, a], [, b]) => b - a)[0];
}

// Files of older benches do not tell the release.
function isOfOtherRelease(engine, first) {
    const isKnown = release => release && release !== 'unknown';
    return isKnown(engine.release) && isKnown(first.release) && engine.release !== first.release;
}

function equality(engine, first) {
    if (isOfOtherRelease(engine, first)) return `made of ODE ${engine.release}, not ${first.release}, so results may differ`;
    if (kSame.includes(engine.state)) return 'the same results in every bit';
    if (engine.state === 'own bits') return 'with bits of its own';
    if (engine.state === 'not reproducible') return 'with other bits in every run';
    return `but its results are other ones: state ${engine.state}`;
}

function sentence(world) {
    const best = fastest(world);
    if (!best) return `${world.world}: only ${world.engines[0].engine} was measured.`;
    const [engine, factor] = best;
    return `${engine.engine} runs ${world.world} at ${number(factor)} times the speed of ${world.engines[0].engine}, ${equality(engine, world.engines[0])}.`;
}

function problems(world) {
    return world.engines.flatMap(engine => {
        if (engine.failure) return [`${world.world}: ${engine.engine} failed: ${engine.failure}`];
        if (engine.firstDifference >= 0 && !['not reproducible', 'own bits'].includes(engine.state))
            return [`${world.world}: ${engine.engine} gave other results, found after frame ${engine.firstDifference}`];
        return [];
    });
}

export function showSummary(results) {
    const { worlds, machine } = results;
    document.getElementById('machine').textContent =
        `${machine.processor}, ${machine.cores} cores; engines: ${engineNames(worlds).join(', ')}`;
    section('summary', 'Summary',
        ...worlds.map(world => element('p', { class: 'summary' }, sentence(world))),
        ...worlds.flatMap(problems).map(text => element('p', { class: 'warning', role: 'alert' }, text)),
        table('What was run', ['world', 'bodies', 'joints', 'geoms', 'step ms', 'frames', 'rounds', 'ended'],
            worlds.map(world => [world.world, ...[world.bodies, world.joints, world.geoms].map(String), number(1000 * world.stepSize),
                String(world.frames), String(world.rounds), world.ended])),
        table('Results and threads of the engines', ['world: engine', 'ODE', 'threads', 'state', 'hash', 'parallel steps', 'messages of ODE'],
            worlds.flatMap(world => world.engines.map(engine => [`${world.world}: ${engine.engine}`, engine.release ?? '–', String(engine.threads || '–'),
                engine.failure ? 'failed' : engine.state, engine.hash, percent(engine.sharedSteps), String(engine.odeMessages)]))));
}

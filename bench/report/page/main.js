// The page: what was measured, and what was recorded.
import { embeddedRecordings, embeddedResults } from './data.js';
import { element } from './elements.js';
import { parseRecording } from './replay/recording.js';
import { Replay } from './replay/replay.js';
import { showFrameTimes } from './results/frame_times.js';
import { showRealTime } from './results/real_time.js';
import { showSizes } from './results/sizes.js';
import { showSpeedUps } from './results/speed_ups.js';
import { showSummary } from './results/summary.js';
import { showThreads } from './results/threads.js';

function showResults(results) {
    showSummary(results);
    showSpeedUps(results);
    showThreads(results);
    showSizes(results);
    showFrameTimes(results);
    showRealTime(results);
}

function warning(text) {
    return element('p', { class: 'warning', role: 'alert' }, text);
}

// Results are shown where there is no WebGL, too.
function showRecordings(recordings) {
    try {
        new Replay(recordings.map(parseRecording));
    } catch (error) {
        document.getElementById('main').append(warning(`The replay cannot be shown: ${error.message}`));
        console.error(error);
    }
}

function fail(error) {
    document.getElementById('main').prepend(warning(`This page cannot be shown: ${error.message}`));
    throw error;
}

async function show() {
    const results = embeddedResults();
    if (results) showResults(results);
    const recordings = await embeddedRecordings();
    if (recordings.length > 0) showRecordings(recordings);
    document.documentElement.dataset.ready = 'true';  // for tests and for pictures
}

show().catch(fail);

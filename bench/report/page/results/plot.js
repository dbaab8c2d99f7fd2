// A plot with its caption and the table of the same numbers below it.
import {
    BarController, BarElement, CategoryScale, Chart, Legend, LinearScale, LineController, LineElement, LogarithmicScale, PointElement,
    Tooltip,
} from 'chart.js';
import { element } from '../elements.js';
import { onThemeChange, themeColour } from '../palette.js';
import { whiskers } from './whiskers.js';

Chart.register(BarController, BarElement, CategoryScale, Legend, LinearScale, LineController, LineElement, LogarithmicScale,
    PointElement, Tooltip, whiskers);
Chart.defaults.animation = false;
Chart.defaults.maintainAspectRatio = false;
Chart.defaults.font.family = 'system-ui, sans-serif';

const charts = [];

function useTheme() {
    Chart.defaults.color = themeColour('--text');
    Chart.defaults.borderColor = themeColour('--line');
    for (const chart of charts) chart.update();
}
useTheme();
onThemeChange(useTheme);

// An axis with a title. `range` may hold `type`, `min`, `suggestedMin`, `beginAtZero`, `ticks`.
export function axis(text, range = {}) {
    return { ...range, title: { display: true, text } };
}

// Whiskers must fit, which Chart.js knows nothing of.
function makeRoom({ data, options }) {
    const tops = data.datasets.flatMap(set => (set.whiskers ?? []).filter(Boolean).map(([, high]) => high));
    if (tops.length > 0) options.scales.y.suggestedMax = Math.max(...tops);
}

// Returns a function that replaces what is shown: a configuration of Chart.js, a description for those who cannot see it, the
// table.
export function plot(parent, caption) {
    const canvas = element('canvas', { role: 'img' });
    const figures = element('div');
    parent.append(element('figure', {}, element('div', { class: 'plot' }, canvas), element('figcaption', {}, caption), figures));
    let chart;
    return (configuration, description, numbers) => {
        if (chart) {
            charts.splice(charts.indexOf(chart), 1);
            chart.destroy();
        }
        canvas.setAttribute('aria-label', `${description} The table below has the numbers.`);
        figures.replaceChildren(numbers);
        makeRoom(configuration);
        chart = new Chart(canvas, configuration);
        charts.push(chart);
    };
}

// A plugin of Chart.js: lower and upper quartile as a line through each bar or point. A data set has them as `whiskers`, one pair
// (or null) a point.
import { themeColour } from '../palette.js';

const kHalfWidth = 4;  // of the caps, in pixels
const kStrokes = [['--surface', 4], ['--text', 1.5]];  // the wider one sets them off from bars of any colour

function draw(context, x, low, high) {
    context.beginPath();
    context.moveTo(x, low);
    context.lineTo(x, high);
    for (const y of [low, high]) {
        context.moveTo(x - kHalfWidth, y);
        context.lineTo(x + kHalfWidth, y);
    }
    context.stroke();
}

export const whiskers = {
    id: 'whiskers',
    afterDatasetsDraw(chart) {
        const context = chart.ctx;
        context.save();
        chart.data.datasets.forEach((set, index) => {
            if (!set.whiskers || !chart.isDatasetVisible(index)) return;
            const scale = chart.scales.y;
            chart.getDatasetMeta(index).data.forEach((point, i) => {
                if (!set.whiskers[i]) return;
                const [low, high] = set.whiskers[i].map(value => scale.getPixelForValue(value));
                for (const [colour, width] of kStrokes) {
                    context.strokeStyle = themeColour(colour);
                    context.lineWidth = width;
                    draw(context, point.x, low, high);
                }
            });
        });
        context.restore();
    },
};

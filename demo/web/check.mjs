// node check.mjs weft.html PICTURE.png: the page in a browser without a window. The flag blows towards the mouse, a ball goes through
// it, nothing crosses, and a picture is taken.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const [, , page, picture] = process.argv, folder = mkdtempSync(join(tmpdir(), 'weft-page-'));

// What a visitor does. The frames of a browser that draws on the processor are slow, so it waits for steps.
const visit = `
const sent = (kind, x, y) => {
    const canvas = document.querySelector('canvas'), box = canvas.getBoundingClientRect();
    canvas.dispatchEvent(new PointerEvent(kind, { clientX: box.left + x * box.width, clientY: box.top + y * box.height, pointerId: 1 }));
};
HTMLElement.prototype.setPointerCapture = () => {};
const stepped = async count => {
    const until = Number(document.body.dataset.steps ?? 0) + count;
    while (Number(document.body.dataset.steps ?? 0) < until && !document.body.dataset.error) await new Promise(done => setTimeout(done, 20));
};
(async () => {
    await stepped(60);
    sent('pointermove', 0.95, 0.5);
    await stepped(120);
    document.body.dataset.right = document.body.dataset.tip;
    sent('pointermove', 0.02, 0.02);
    await stepped(120);
    document.body.dataset.left = document.body.dataset.tip;
    sent('pointermove', 0.95, 0.45);
    await stepped(90);
    sent('pointerdown', 0.5, 0.5);
    await stepped(70);
    document.body.dataset.visited = 'yes';
})();`;
const visited = join(folder, 'visited.html');
writeFileSync(visited, readFileSync(page, 'utf8').replace('</html>', () => '<script>' + visit + '</script></html>'));

const browser = (...what) => execFileSync('chromium', ['--headless', '--no-sandbox', '--enable-unsafe-swiftshader', '--use-angle=swiftshader',
    '--window-size=1200,750', '--hide-scrollbars', '--user-data-dir=' + join(folder, 'profile'), '--virtual-time-budget=60000', ...what,
    'file://' + visited], { stdio: ['ignore', 'pipe', 'pipe'], timeout: 300000, maxBuffer: 1 << 28 }).toString();

const body = browser('--dump-dom').match(/<body[^>]*>/)?.[0] ?? '';
browser('--screenshot=' + picture);
const value = name => body.match(new RegExp('data-' + name + '="([^"]*)"'))?.[1];
const right = value('right')?.split(' ').map(Number), left = value('left')?.split(' ').map(Number);
console.log(body);
const failures = [
    [value('error') !== undefined, 'the page says ' + value('error')],
    [value('visited') !== 'yes', 'the visit did not come to its end'],
    [!right || !left || !(right[0] > left[0] + 0.3), 'the flag does not blow towards the mouse: ' + right + '; ' + left],
    [value('crossings') !== '0', 'cloth crosses'],
    [value('gl-error') !== '0', 'WebGL error ' + value('gl-error')],
].filter(([failed]) => failed);
for (const [, why] of failures) console.error(why);
process.exit(failures.length > 0 ? 1 : 0);

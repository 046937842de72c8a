// Draws what cloth.cpp steps, by WebGL 2. build.mjs puts the program's bytes into `program`.
'use strict';

// The WASI calls of the program: a clock, and text for the console.
function systemFor(memory) {
    const nothing = 0, notThere = 52;
    const calls = {
        clock_time_get(_id, _precision, to) {
            new DataView(memory().buffer).setBigUint64(to, BigInt(Math.round(performance.now() * 1e6)), true);
            return nothing;
        },
        fd_write(_file, parts, count, written) {
            const view = new DataView(memory().buffer);
            let bytes = 0;
            for (let i = 0; i < count; ++i) {
                const at = view.getUint32(parts + 8 * i, true), length = view.getUint32(parts + 8 * i + 4, true);
                console.log(new TextDecoder().decode(new Uint8Array(memory().buffer, at, length)));
                bytes += length;
            }
            view.setUint32(written, bytes, true);
            return nothing;
        },
        environ_sizes_get(count, bytes) {
            const view = new DataView(memory().buffer);
            view.setUint32(count, 0, true);
            view.setUint32(bytes, 0, true);
            return nothing;
        },
        environ_get: () => nothing,
        proc_exit(code) { throw new Error('the program ended with ' + code); },
    };
    return new Proxy(calls, { get: (of, name) => of[name] ?? (() => notThere) });
}

async function loadCloth(bytes) {
    let exports = null;
    const { instance } = await WebAssembly.instantiate(bytes, { wasi_snapshot_preview1: systemFor(() => exports.memory) });
    exports = instance.exports;
    exports._initialize();
    return exports;
}

const vertexShader = `#version 300 es
uniform mat4 view;
in vec3 position, normal;
out vec3 n, p;
void main() { p = position; n = normal; gl_Position = view * vec4(position, 1); }`;
const fragmentShader = `#version 300 es
precision highp float;
uniform vec3 colour;
uniform vec3 eye;
in vec3 n, p;
out vec4 drawn;
void main() {
    vec3 to = normalize(eye - p), facing = normalize(n) * (dot(n, to) < 0. ? -1. : 1.);
    float sun = max(dot(facing, normalize(vec3(.4, .8, .6))), 0.), sky = .5 + .5 * facing.y;
    float gloss = pow(max(dot(facing, normalize(to + normalize(vec3(.4, .8, .6)))), 0.), 40.);
    drawn = vec4(colour * (.4 + .3 * sky + .6 * sun) + .1 * gloss, 1);
}`;

function makeProgram(gl) {
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
}

// View and perspective of the eye at (0, 0, distance), looking along -z.
function viewFrom(distance, aspect) {
    const f = 1 / Math.tan(0.35), near = 0.1, far = 20, depth = near - far;
    const a = (far + near) / depth, b = 2 * far * near / depth;
    return new Float32Array([f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, a, -1, 0, 0, -distance * a + b, distance]);
}

function ballMesh(radius, rings = 24, sides = 32) {
    const vertices = [], triangles = [];
    for (let i = 0; i <= rings; ++i)
        for (let j = 0; j <= sides; ++j) {
            const a = Math.PI * i / rings, b = 2 * Math.PI * j / sides;
            const n = [Math.sin(a) * Math.cos(b), Math.cos(a), Math.sin(a) * Math.sin(b)];
            vertices.push(...n.map(x => x * radius), ...n);
            const k = i * (sides + 1) + j;
            if (i < rings && j < sides) triangles.push(k, k + 1, k + sides + 1, k + 1, k + sides + 2, k + sides + 1);
        }
    return { vertices: new Float32Array(vertices), triangles: new Uint32Array(triangles) };
}

class Drawing {
    constructor(gl, program) {
        this.gl = gl;
        this.array = gl.createVertexArray();
        this.vertices = gl.createBuffer();
        this.triangles = gl.createBuffer();
        gl.bindVertexArray(this.array);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.vertices);
        for (const [name, at] of [['position', 0], ['normal', 12]]) {
            const place = gl.getAttribLocation(program, name);
            gl.enableVertexAttribArray(place);
            gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 24, at);
        }
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.triangles);
    }
    setTriangles(triangles) {
        this.gl.bindVertexArray(this.array);
        this.gl.bufferData(this.gl.ELEMENT_ARRAY_BUFFER, triangles, this.gl.STATIC_DRAW);
        this.count = triangles.length;
    }
    setVertices(vertices) {
        this.gl.bindBuffer(this.gl.ARRAY_BUFFER, this.vertices);
        this.gl.bufferData(this.gl.ARRAY_BUFFER, vertices, this.gl.DYNAMIC_DRAW);
    }
    draw() {
        this.gl.bindVertexArray(this.array);
        this.gl.drawElements(this.gl.TRIANGLES, this.count, this.gl.UNSIGNED_INT, 0);
    }
}

function textAt(cloth, at) {
    const bytes = new Uint8Array(cloth.memory.buffer, at);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
}

async function main() {
    const cloth = await loadCloth(Uint8Array.from(atob(program), c => c.charCodeAt(0)));
    const canvas = document.querySelector('canvas'), input = name => document.getElementById(name);
    const gl = canvas.getContext('webgl2', { antialias: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error('this browser has no WebGL 2');
    const shaders = makeProgram(gl), uniform = name => gl.getUniformLocation(shaders, name);
    const distance = 2.9, flag = new Drawing(gl, shaders), ball = new Drawing(gl, shaders);
    const sphere = ballMesh(0.145);
    ball.setTriangles(sphere.triangles);

    for (let i = 0; textAt(cloth, cloth.fabric_name(i)) !== ''; ++i)
        input('fabric').add(new Option(textAt(cloth, cloth.fabric_name(i)), i, false, textAt(cloth, cloth.fabric_name(i)) === 'flag'));

    function make() {
        const rows = Number(input('size').value), columns = Math.round(1.5 * rows);
        if (!cloth.make(rows, columns, Number(input('fabric').value))) throw new Error(textAt(cloth, cloth.error()));
        flag.setTriangles(new Uint32Array(cloth.memory.buffer, cloth.triangles(), 3 * cloth.triangle_count()).slice());
    }
    make();
    input('size').onchange = input('fabric').onchange = () => {
        delete document.body.dataset.error;
        try { make(); } catch (error) { tell(error); }
    };

    for (const name of ['wind', 'gust', 'size']) {
        const show = () => { input(name).nextElementSibling.textContent = input(name).value; };
        input(name).oninput = show;
        show();
    }

    // The wind blows towards the mouse; while a button is down the mouse moves the ball.
    const mouse = { x: 0.6, y: 0.05, isDown: false, ball: [0, -5, 0] };
    const place = event => {
        const box = canvas.getBoundingClientRect();
        mouse.x = 2 * (event.clientX - box.left) / box.width - 1;
        mouse.y = 1 - 2 * (event.clientY - box.top) / box.height;
    };
    canvas.onpointermove = place;
    canvas.onpointerdown = event => {
        place(event);
        mouse.isDown = true;
        canvas.setPointerCapture(event.pointerId);
        mouse.ball = [...spot(), 0.6];
        cloth.place_ball(...mouse.ball);
    };
    canvas.onpointerup = canvas.onpointercancel = () => {
        mouse.isDown = false;
        mouse.ball = [0, -5, 0];
        cloth.place_ball(...mouse.ball);
    };
    const spot = () => [mouse.x * distance * Math.tan(0.35) * canvas.width / canvas.height, mouse.y * distance * Math.tan(0.35)];
    canvas.addEventListener('wheel', event => { mouse.ball[2] -= 0.001 * event.deltaY; }, { passive: true });

    let last = performance.now(), steps = 0, mean = 0;
    function frame(now) {
        try { step(now); } catch (error) { return tell(error); }
        requestAnimationFrame(frame);
    }
    function step(now) {
        const speed = Number(input('wind').value), length = Math.hypot(mouse.x + 0.5, mouse.y, 0.5) || 1;
        cloth.set_wind(speed * (mouse.x + 0.5) / length, speed * mouse.y / length, speed * 0.5 / length, Number(input('gust').value));
        if (mouse.isDown) {
            mouse.ball[2] = Math.max(mouse.ball[2] - 0.01, -0.2);  // the ball comes through the flag
            mouse.ball = [...spot(), mouse.ball[2]];
            cloth.move_ball(...mouse.ball);
        }
        steps += cloth.advance((now - last) / 1000);
        last = now;
        mean += 0.05 * (cloth.milliseconds() - mean);

        canvas.width = canvas.clientWidth, canvas.height = canvas.clientHeight;
        gl.viewport(0, 0, canvas.width, canvas.height);
        gl.clearColor(0.86, 0.9, 0.94, 1);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        gl.enable(gl.DEPTH_TEST);
        gl.useProgram(shaders);
        gl.uniformMatrix4fv(uniform('view'), false, viewFrom(distance, canvas.width / canvas.height));
        gl.uniform3f(uniform('eye'), 0, 0, distance);
        gl.uniform3f(uniform('colour'), 0.85, 0.2, 0.17);
        flag.setVertices(new Float32Array(cloth.memory.buffer, cloth.vertices(), 6 * cloth.vertex_count()));
        flag.draw();
        if (mouse.isDown) {
            gl.uniform3f(uniform('colour'), 0.9, 0.75, 0.3);
            ball.setVertices(sphere.vertices.map((x, i) => i % 6 < 3 ? x + mouse.ball[i % 6] : x));
            ball.draw();
        }
        const body = document.body.dataset;
        body.steps = steps, body.crossings = cloth.crossings(), body.glError = gl.getError();
        body.tip = new Float32Array(cloth.memory.buffer, cloth.vertices() + 24 * (cloth.vertex_count() - 1), 3).join(' ');
        if (!body.error) input('report').textContent = `${cloth.vertex_count()} particles, ${mean.toFixed(2)} ms a step`;
    }
    requestAnimationFrame(frame);
}
function tell(error) {
    document.getElementById('report').textContent = document.body.dataset.error = error.message;
}
main().catch(tell);

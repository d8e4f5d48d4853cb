// SPDX-License-Identifier: BSD-3-Clause
// Draws the frames of a run by three.js: a square for each particle, on which the shader paints a sphere; a rock by its faces. server.h has the addresses.
import * as THREE from "./three.module.min.js";
import {OrbitControls} from "./OrbitControls.js";

const HEAD = 512, VALUE = 4, ROCK = 5; // shot.h: places in a row; head.numbers is its length
const get = (id) => document.getElementById(id);
const short = (value) => Number(value).toPrecision(4).replace(/(\.\d*?)0+($|e)/, "$1$2").replace(/\.($|e)/, "$1");
const colours = ["#264653", "#2a6f7d", "#2a9d8f", "#8ab17d", "#e9c46a", "#f4a261", "#e76f51"].map((text) => new THREE.Color(text));

// The row of a particle. A sphere has no rock: 0, as have all particles of a run without rocks.
const vertex = `
attribute vec3 place;
attribute float radius, value, rock;
uniform vec3 cutLow, cutHigh;
uniform float low, high;
varying vec2 corner;
varying float shade, depth, size;
void main() {
    corner = position.xy;
    size = radius;
    shade = clamp((value - low) / max(high - low, 1e-30), 0.0, 1.0);
    vec4 centre = viewMatrix * vec4(place, 1.0);
    depth = centre.z;
    bool cut = rock > 0.5 || any(lessThan(place, cutLow)) || any(greaterThan(place, cutHigh));
    gl_Position = cut ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * (centre + vec4(corner * radius, 0.0, 0.0));
}`;
const paint = `
uniform vec3 ramp[7];
vec4 paint(float shade, vec3 normal) {
    float light = 0.35 + 0.65 * max(dot(normal, normalize(vec3(0.4, 0.6, 0.8))), 0.0);
    float at = shade * 6.0;
    vec3 colour = ramp[0];
    for (int k = 0; k < 6; k++) colour = mix(colour, ramp[k + 1], clamp(at - float(k), 0.0, 1.0));
    return vec4(pow(colour * light, vec3(1.0 / 2.2)), 1.0);
}`;
const fragment = paint + `
uniform mat4 projection;
varying vec2 corner;
varying float shade, depth, size;
void main() {
    float r2 = dot(corner, corner);
    if (r2 > 1.0) discard;
    vec3 normal = vec3(corner, sqrt(1.0 - r2));
    vec4 front = projection * vec4(0.0, 0.0, depth + normal.z * size, 1.0);
    gl_FragDepth = 0.5 * front.z / front.w + 0.5;
    gl_FragColor = paint(shade, normal);
}`;
// Rocks: corners in units of the ball, turned by the quaternion x y z w of the row.
const rockVertex = `
attribute vec3 place;
attribute float radius, value;
attribute vec4 turn;
uniform vec3 cutLow, cutHigh;
uniform float low, high;
varying float shade;
varying vec3 facing;
vec3 turned(vec3 x) { return x + 2.0 * cross(turn.xyz, cross(turn.xyz, x) + turn.w * x); }
void main() {
    shade = clamp((value - low) / max(high - low, 1e-30), 0.0, 1.0);
    facing = mat3(viewMatrix) * turned(normal);
    bool cut = any(lessThan(place, cutLow)) || any(greaterThan(place, cutHigh));
    gl_Position = cut ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * viewMatrix * vec4(place + radius * turned(position), 1.0);
}`;
const rockFragment = paint + `
varying float shade;
varying vec3 facing;
void main() { gl_FragColor = paint(shade, normalize(facing)); }`;

const canvas = get("particles");
const renderer = new THREE.WebGLRenderer({canvas: canvas, antialias: true});
renderer.setClearColor(0xfbfaf7);
const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(35, 1, 0.01, 1000);
camera.up.set(0, 0, 1);
const orbit = new OrbitControls(camera, canvas);
const uniforms = {cutLow: {value: new THREE.Vector3(-1e30, -1e30, -1e30)}, cutHigh: {value: new THREE.Vector3(1e30, 1e30, 1e30)},
    low: {value: 0}, high: {value: 1}, ramp: {value: colours}, projection: {value: camera.projectionMatrix}};
const geometry = new THREE.InstancedBufferGeometry();
geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), 3));
geometry.setIndex([0, 1, 2, 0, 2, 3]);
geometry.instanceCount = 0;
const spheres = new THREE.Mesh(geometry, new THREE.ShaderMaterial({vertexShader: vertex, fragmentShader: fragment, uniforms: uniforms}));
spheres.frustumCulled = false;
scene.add(spheres);
const rockMaterial = new THREE.ShaderMaterial({vertexShader: rockVertex, fragmentShader: rockFragment, uniforms: uniforms});
let rocks = []; // a mesh for each shape of about.shapes
const box = new THREE.LineSegments(new THREE.EdgesGeometry(new THREE.BoxGeometry(1, 1, 1)), new THREE.LineBasicMaterial({color: 0xb0aa9c}));
scene.add(box);

let about = null, frame = 0, paused = false, ended = false, drawn = 0, waiting = false;

function drawNow() {
    const width = canvas.clientWidth, height = canvas.clientHeight;
    waiting = false;
    renderer.setPixelRatio(window.devicePixelRatio);
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    renderer.render(scene, camera);
    document.body.dataset.drawn = geometry.instanceCount;
    document.body.dataset.rocks = rocks.reduce((sum, mesh) => sum + (mesh ? mesh.geometry.instanceCount : 0), 0);
}
function draw() {
    if (!waiting) requestAnimationFrame(drawNow);
    waiting = true;
}

function lookAt(low, edge) {
    const middle = low.map((x, d) => x + edge[d] / 2), size = Math.hypot(...edge);
    box.scale.set(...edge);
    box.position.set(...middle);
    if (drawn++) return;
    camera.near = size / 500;
    camera.far = 20 * size;
    orbit.target.set(...middle);
    if (about.dimension === 2) camera.up.set(0, 1, 0);
    const side = about.dimension === 2 ? [0, 0, 1.7] : [0.95, -1.35, 0.65];
    camera.position.set(...middle.map((x, d) => x + side[d] * size));
    orbit.update();
}

// The polygons of a shape as triangles, each with the normal of its polygon.
function rockMesh(shape) {
    const place = [], normal = [], corner = (k) => new THREE.Vector3().fromArray(shape.corners, 3 * k);
    shape.polygons.forEach((ring) => {
        const points = ring.map(corner), across = new THREE.Vector3();
        for (let k = 2; k < points.length; k++)
            across.add(points[k - 1].clone().sub(points[0]).cross(points[k].clone().sub(points[0])));
        across.normalize();
        for (let k = 2; k < points.length; k++)
            [points[0], points[k - 1], points[k]].forEach((point) => {
                place.push(...point.toArray());
                normal.push(...across.toArray());
            });
    });
    const mesh = new THREE.Mesh(new THREE.InstancedBufferGeometry(), rockMaterial);
    mesh.geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(place), 3));
    mesh.geometry.setAttribute("normal", new THREE.BufferAttribute(new Float32Array(normal), 3));
    mesh.geometry.instanceCount = 0;
    mesh.frustumCulled = mesh.visible = false;
    scene.add(mesh);
    return mesh;
}

// Columns of the rows for one attribute each.
function setRows(target, rows, numbers, columns) {
    const buffer = new THREE.InstancedInterleavedBuffer(rows, numbers);
    target.dispose();
    for (const [name, [first, size]] of Object.entries(columns))
        target.setAttribute(name, new THREE.InterleavedBufferAttribute(buffer, size, first));
}

// Each mesh gets the rows of its shape.
function showRocks(rows, head) {
    rocks.forEach((mesh, shape) => {
        if (!mesh) return;
        const own = [];
        for (let k = 0; k < head.count; k++)
            if (rows[head.numbers * k + ROCK] === shape + 1) own.push(k);
        const part = new Float32Array(own.length * head.numbers);
        own.forEach((k, n) => part.set(rows.subarray(head.numbers * k, head.numbers * (k + 1)), n * head.numbers));
        mesh.visible = own.length > 0;
        mesh.geometry.instanceCount = own.length;
        setRows(mesh.geometry, part, head.numbers, {place: [0, 3], radius: [3, 1], value: [VALUE, 1], turn: [ROCK + 1, 4]});
    });
}

// The lowest and highest value; of a velocity all but the fastest hundredth.
function range(rows, count, numbers, speed) {
    const values = new Float32Array(count);
    for (let k = 0; k < count; k++) values[k] = rows[numbers * k + VALUE];
    values.sort();
    return count ? [values[0], values[speed ? Math.floor(0.99 * (count - 1)) : count - 1]] : [0, 1];
}

function show(data) {
    const head = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 0, HEAD)));
    const rows = new Float32Array(data, HEAD), rock = rocks.length ? {rock: [ROCK, 1]} : {};
    setRows(geometry, rows, head.numbers, {place: [0, 3], radius: [3, 1], value: [VALUE, 1], ...rock});
    geometry.instanceCount = head.count;
    showRocks(rows, head);
    const field = about.fields[head.field] || about.fields[0];
    [uniforms.low.value, uniforms.high.value] = range(rows, head.count, head.numbers, field.name === "velocity");
    get("low").textContent = short(uniforms.low.value);
    get("high").textContent = short(uniforms.high.value) + " " + field.unit;
    const s = about.fields.some((one) => one.unit) ? " s" : "";
    get("state").textContent = `step ${head.step}\ntime ${short(head.time)}${s}\n${head.total} particles`;
    get("thin").textContent = head.count < head.total ? `${head.count} of ${head.total} particles are shown` : "";
    paused = head.paused;
    get("pause").textContent = paused ? "go" : "pause";
    lookAt(about.lower, head.edge);
    drawNow();
}

async function follow() {
    try {
        const answer = await fetch(`frame?field=${get("field").value || 0}&after=${frame}`);
        if (answer.status === 200) {
            frame = Number(answer.headers.get("X-Frame"));
            const data = await answer.arrayBuffer();
            if (data.byteLength >= HEAD) show(data);
        }
        setTimeout(follow, answer.status === 200 ? 60 : 40);
    } catch (error) {
        ended = true;
        get("state").textContent += "\nthe run has ended";
    }
}

async function post(what) {
    await fetch(what, {method: "POST"});
}

function prepare() {
    get("title").textContent = document.title = about.title || "scree";
    about.fields.forEach((field, k) => get("field").add(new Option(field.unit ? `${field.name} (${field.unit})` : field.name, k)));
    const ramp = get("ramp").getContext("2d"), gradient = ramp.createLinearGradient(0, 0, 64, 0);
    colours.forEach((colour, k) => gradient.addColorStop(k / 6, "#" + colour.getHexString()));
    ramp.fillStyle = gradient;
    ramp.fillRect(0, 0, 64, 1);
    rocks = (about.shapes || []).map((shape) => shape && rockMesh(shape));
    get("pause").onclick = () => post(paused ? "go" : "pause");
    get("step").onclick = () => post(`step?count=${Math.max(1, get("count").valueAsNumber || 1)}`);
    ["x", "y", "z"].forEach((name, d) => {
        const label = document.createElement("label");
        label.append(name);
        ["cutLow", "cutHigh"].forEach((which, side) => {
            const input = document.createElement("input");
            Object.assign(input, {type: "range", min: 0, max: 1, step: 0.005, value: side, title: side ? "upper cut" : "lower cut"});
            input.oninput = () => {
                const whole = side ? input.value >= 1 : input.value <= 0;
                uniforms[which].value.setComponent(d, whole ? (side ? 1e30 : -1e30) : about.lower[d] + input.value * box.scale.getComponent(d));
                draw();
            };
            label.append(input);
        });
        get("cuts").append(label);
    });
    orbit.addEventListener("change", draw);
    window.addEventListener("resize", draw);
}

// The table of observables: rows as they come, one column as a plot.
const table = {names: null, rows: [], from: 0, rest: "", plot: null};
function plotColumn() {
    const k = Number(get("column").value), every = Math.ceil(table.rows.length / 2000), rows = table.rows.filter((row, n) => n % every === 0);
    const data = [rows.map((row) => row[0]), rows.map((row) => row[k])];
    if (table.plot) table.plot.destroy();
    table.plot = new uPlot({width: 270, height: 190, legend: {show: false}, scales: {x: {time: false}},
        series: [{}, {stroke: "#e76f51", width: 1.5}],
        axes: [{label: table.names[0], labelSize: 18, size: 30}, {size: 56, values: (u, all) => all.map(short)}]}, data, get("plot"));
}
async function readTable() {
    if (ended) return;
    try {
        const answer = await fetch(`observables?from=${table.from}`), text = answer.status === 200 ? await answer.text() : "";
        table.from += new TextEncoder().encode(text).length;
        const lines = (table.rest + text).split("\n");
        table.rest = lines.pop();
        if (!table.names && lines.length) {
            table.names = lines.shift().split(",");
            table.names.slice(1).forEach((name, k) => get("column").add(new Option(name, k + 1)));
            get("column").onchange = plotColumn;
            get("columns").hidden = false;
        }
        lines.forEach((line) => table.rows.push(line.split(",").map(Number)));
        if (lines.length) plotColumn();
        document.body.dataset.rows = table.rows.length;
        setTimeout(readTable, 500);
    } catch (error) {
        return;
    }
}

about = await (await fetch("about")).json();
prepare();
follow();
readTable();

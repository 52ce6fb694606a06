// Turns the models of the gallery in its page: plain WebGL2, nothing from elsewhere, also when the page is opened as a file.
//
// A browser lets a page that is a file read no other files, but run scripts beside it: so NAME.glb.js hands over the bytes of NAME.glb, when the model
// is first turned. One canvas serves all cards; the picture comes back where another model is turned.
"use strict";
(() => {
  // Vectors are arrays of three, matrices arrays of sixteen by columns; y is up, as in the file.

  const add = (a, b, t = 1) => [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const unit = (a) => add([0, 0, 0], a, 1 / Math.hypot(...a));
  const clamp = (value, least, most) => Math.min(Math.max(value, least), most);

  const product = (a, b) => {
    const c = new Array(16);
    for (let column = 0; column < 4; column++) {
      for (let row = 0; row < 4; row++) {
        c[4 * column + row] = [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + row] * b[4 * column + k], 0);
      }
    }
    return c;
  };
  const image = (m, p) => [0, 1, 2].map((row) => m[row] * p[0] + m[4 + row] * p[1] + m[8 + row] * p[2] + m[12 + row]);
  const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

  /** The matrix of a node of glTF: scaled, turned by a unit quaternion [x, y, z, w], moved. */
  const placement = ({ translation: t = [0, 0, 0], rotation: [x, y, z, w] = [0, 0, 0, 1], scale: s = [1, 1, 1] }) => [
    s[0] * (1 - 2 * (y * y + z * z)), s[0] * 2 * (x * y + z * w), s[0] * 2 * (x * z - y * w), 0,
    s[1] * 2 * (x * y - z * w), s[1] * (1 - 2 * (x * x + z * z)), s[1] * 2 * (y * z + x * w), 0,
    s[2] * 2 * (x * z + y * w), s[2] * 2 * (y * z - x * w), s[2] * (1 - 2 * (x * x + y * y)), 0,
    t[0], t[1], t[2], 1,
  ];

  // ---- The file ----

  /** Reads what `cyclide` writes into GLB: triangles with normals, lines, places of nodes, one animation. */
  const readGlb = (buffer) => {
    const view = new DataView(buffer);
    const length = view.getUint32(12, true);
    const json = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 20, length)));
    const start = 28 + length;
    const array = (index) => {
      const accessor = json.accessors[index];
      const from = start + (json.bufferViews[accessor.bufferView].byteOffset ?? 0) + (accessor.byteOffset ?? 0);
      const width = { SCALAR: 1, VEC3: 3, VEC4: 4 }[accessor.type];
      const Kind = { 5125: Uint32Array, 5126: Float32Array }[accessor.componentType];
      return new Kind(buffer, from, width * accessor.count);
    };
    const primitive = ({ attributes, indices, material, mode }) => {
      const look = json.materials[material];
      const colour = look.pbrMetallicRoughness.baseColorFactor.slice(0, 3);
      const positions = array(attributes.POSITION);
      return { lines: mode === 1, colour, positions, normals: attributes.NORMAL === undefined ? null : array(attributes.NORMAL), indices: array(indices) };
    };
    const channels = (json.animations?.[0]?.channels ?? []).map(({ target, sampler }) => {
      const { input, output, interpolation } = json.animations[0].samplers[sampler];
      return { node: target.node, path: target.path, times: array(input), values: array(output), steps: interpolation === "STEP" };
    });
    return {
      meshes: json.meshes.map((mesh) => mesh.primitives.map(primitive)),
      nodes: json.nodes,
      roots: json.scenes[json.scene].nodes,
      channels,
      duration: channels.reduce((most, { times }) => Math.max(most, times[times.length - 1]), 0),
    };
  };

  /** The value of a channel at a time. */
  const valueAt = ({ path, times, values, steps }, time) => {
    const width = values.length / times.length;
    let [low, high] = [0, times.length - 1];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= time) low = middle;
      else high = middle;
    }
    if (time >= times[high]) low = high;
    const part = steps || high === low ? 0 : clamp((time - times[low]) / (times[high] - times[low]), 0, 1);
    const [a, b] = [low, high].map((k) => Array.from(values.subarray(k * width, (k + 1) * width)));
    let [p, q] = [1 - part, part];
    if (path === "rotation") {
      const cosine = a.reduce((sum, value, k) => sum + value * b[k], 0);
      const angle = Math.acos(clamp(Math.abs(cosine), 0, 1));
      if (angle > 1e-4) [p, q] = [Math.sin(p * angle) / Math.sin(angle), Math.sin(q * angle) / Math.sin(angle)];
      if (cosine < 0) q = -q;
    }
    return a.map((value, k) => p * value + q * b[k]);
  };

  /** The meshes of a scene with their matrices at a time. */
  const placed = (scene, time) => {
    const moved = new Map();
    for (const channel of scene.channels) {
      moved.set(channel.node, { ...moved.get(channel.node), [channel.path]: valueAt(channel, time) });
    }
    const found = [];
    const visit = (index, above) => {
      const node = { ...scene.nodes[index], ...moved.get(index) };
      const matrix = product(above, placement(node));
      if (node.mesh !== undefined) found.push({ mesh: node.mesh, matrix });
      for (const child of node.children ?? []) visit(child, matrix);
    };
    for (const root of scene.roots) visit(root, IDENTITY);
    return found;
  };

  /** Moments of a motion at which its box is held in view. */
  const MOMENTS = 48;

  /** Places that the view has to hold: all vertices of what rests; of what moves, its box at many times. */
  const extent = (scene) => {
    const moments = scene.duration > 0 ? Array.from({ length: MOMENTS + 1 }, (_, k) => (scene.duration * k) / MOMENTS) : [0];
    const places = moments.map((time) => placed(scene, time));
    const points = [];
    places[0].forEach(({ mesh, matrix }, index) => {
      const rests = places.every((now) => now[index].matrix.every((value, k) => value === matrix[k]));
      for (const { positions } of scene.meshes[mesh]) {
        if (rests) {
          for (let i = 0; i < positions.length; i += 3) points.push(image(matrix, positions.subarray(i, i + 3)));
          continue;
        }
        const ends = box(positions);
        for (let corner = 0; corner < 8; corner++) {
          const at = [0, 1, 2].map((axis) => ends[(corner >> axis) & 1][axis]);
          for (const now of places) points.push(image(now[index].matrix, at));
        }
      }
    });
    return points;
  };

  /** Least and greatest coordinates of a flat list of places. */
  const box = (flat) => {
    const [min, max] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
    for (let i = 0; i < flat.length; i++) {
      const axis = i % 3;
      min[axis] = Math.min(min[axis], flat[i]);
      max[axis] = Math.max(max[axis], flat[i]);
    }
    return [min, max];
  };

  // ---- The eye: lens and margin are those of the pictures ----

  const HALF_HEIGHT = 0.393910475614942;
  const FILLED = 0.92;

  class Eye {
    constructor(points, azimuth, elevation) {
      this.points = points;
      const [min, max] = box(points.flat());
      this.middle = add(min, max).map((value) => value / 2);
      this.radius = points.reduce((most, p) => Math.max(most, Math.hypot(...add(p, this.middle, -1))), 0) || 1;
      this.first = [azimuth, elevation];
      this.aspect = 4 / 3;
      this.whole();
    }

    /** Right, up and toward the eye. */
    axes() {
      const [sa, ca, se, ce] = [Math.sin(this.azimuth), Math.cos(this.azimuth), Math.sin(this.elevation), Math.cos(this.elevation)];
      const [right, toward] = [[ca, 0, -sa], [sa * ce, se, ca * ce]];
      return [right, cross(toward, right), toward];
    }

    /** The first view, in which the model fills the picture. */
    whole() {
      [this.azimuth, this.elevation] = this.first;
      this.target = this.middle;
      this.distance = this.home = this.frame().distance;
      this.center();
    }

    /** The model turns about its middle, but how far its sides are seen from there is another in each view: `aside` is how far the eye stands beside the
     * line to the target, to the right and up in parts of the distance, so that the margins are equal. */
    center() {
      this.aside = this.frame().aside.map((length) => length / this.home);
    }

    /** How far from the middle the eye has to be to see all, and how far beside it with equal margins. */
    frame() {
      const [right, up, toward] = this.axes();
      const [v, h] = [FILLED * HALF_HEIGHT, FILLED * HALF_HEIGHT * this.aspect];
      const most = [-Infinity, -Infinity, -Infinity, -Infinity];
      for (const p of this.points) {
        const d = add(p, this.middle, -1);
        const [x, y, z] = [dot(d, right), dot(d, up), dot(d, toward)];
        [h * z + x, h * z - x, v * z + y, v * z - y].forEach((value, k) => (most[k] = Math.max(most[k], value)));
      }
      const distance = Math.max((most[0] + most[1]) / (2 * h), (most[2] + most[3]) / (2 * v), 1e-3 * this.radius);
      return { distance, aside: [(most[0] - most[1]) / 2, (most[2] - most[3]) / 2] };
    }

    turn(right, up) {
      this.azimuth -= right;
      this.elevation = clamp(this.elevation + up, -Math.PI / 2, Math.PI / 2);
      this.center();
    }

    /** Moves the model by parts of the picture's height. */
    move(x, y, distance = this.distance) {
      const [right, up] = this.axes();
      const step = 2 * HALF_HEIGHT * distance;
      const moved = add(add(this.target, right, -x * step), up, -y * step);
      // What is turned stays in sight.
      const away = add(moved, this.middle, -1);
      this.target = add(this.middle, away, Math.min(1, (2 * this.radius) / (Math.hypot(...away) || 1)));
    }

    /** Comes nearer to what is at a place of the picture, in parts of its height from its middle; without a place, to what the model turns about. */
    zoom(factor, place) {
      const before = this.distance;
      this.distance = clamp(before * factor, 0.05 * this.radius, 20 * this.radius);
      if (!place) return;
      const part = this.distance / before - 1;
      const [x, y] = place.map((value, k) => value + this.aside[k] / (2 * HALF_HEIGHT));
      this.move(part * x, part * y, before);
    }

    /** What the programs need. */
    view() {
      const [right, up, toward] = this.axes();
      const beside = add(add(toward, right, this.aside[0]), up, this.aside[1]);
      const eye = add(this.target, beside, this.distance);
      const depth = dot(add(eye, this.middle, -1), toward);
      const [near, far] = [Math.max(depth - 1.01 * this.radius, 0.004 * this.radius), Math.max(depth, 0) + 1.01 * this.radius];
      const at = (axis) => -dot(axis, eye);
      const look = [right[0], up[0], toward[0], 0, right[1], up[1], toward[1], 0, right[2], up[2], toward[2], 0, at(right), at(up), at(toward), 1];
      const [c1, c2] = [(far + near) / (far - near), (2 * far * near) / (far - near)];
      const lens = [1 / (HALF_HEIGHT * this.aspect), 0, 0, 0, 0, 1 / HALF_HEIGHT, 0, 0, 0, 0, -c1, -1, 0, 0, -c2, 0];
      const level = Math.hypot(toward[0], toward[2]) > 0.1 ? unit([toward[0], 0, toward[2]]) : up.map((value) => -value);
      const key = unit(add(add([0, 1, 0], right, -0.55), level, 0.25));
      const fill = unit(add(add([0, 0.2, 0], right, 0.9), level, 0.5));
      return { matrix: product(lens, look), eye, key, fill, lift: c2 };
    }
  }

  // ---- Drawing ----

  const SCREEN = `vec3 onScreen(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
  }`;

  const SURFACE = [
    `#version 300 es
    in vec3 position, normal;
    uniform mat4 view, model;
    out vec3 place, across;
    void main() {
      vec4 p = model * vec4(position, 1.0);
      place = p.xyz;
      across = mat3(model) * normal;
      gl_Position = view * p;
    }`,
    // Light is that of the pictures: a broad one from behind the left shoulder, a weak one from the right, sky and earth.
    `#version 300 es
    precision highp float;
    in vec3 place, across;
    uniform vec3 tint, eye, key, fill;
    out vec4 colour;
    ${SCREEN}
    void main() {
      // Seen from behind, a surface has the light of its other side.
      vec3 n = normalize(gl_FrontFacing ? across : -across), toEye = normalize(eye - place);
      float sky = 0.5 + 0.5 * n.y;
      float matt = 0.70 * max((dot(n, key) + 0.12) / 1.12, 0.0) + 0.14 * max(dot(n, fill), 0.0) + mix(0.24, 0.42, sky);
      float h = max(dot(normalize(key + toEye), n), 0.0);
      float gloss = dot(n, key) > 0.0 ? 0.16 * pow(h, 64.0) + 0.05 * pow(h, 12.0) : 0.0;
      float away = 1.0 - clamp(dot(n, toEye), 0.0, 1.0);
      colour = vec4(onScreen(tint * matt + gloss + 0.16 * sky * pow(away, 4.0)), 1.0);
    }`,
  ];

  // A piece of a line is a strip of four corners, as wide everywhere, lifted a little toward the eye off the surface on which it lies.
  const LINE = [
    `#version 300 es
    in vec3 from, to;
    uniform mat4 view, model;
    uniform vec2 pixels;
    uniform float lift, width;
    void main() {
      vec4 a = view * (model * vec4(from, 1.0)), b = view * (model * vec4(to, 1.0));
      float inA = a.z + a.w, inB = b.z + b.w;
      if (inA < 0.0 && inB > 0.0) a = mix(a, b, inA / (inA - inB));
      else if (inB < 0.0 && inA > 0.0) b = mix(b, a, inB / (inB - inA));
      vec2 along = (b.xy / b.w - a.xy / a.w) * pixels;
      float size = length(along);
      along = size > 0.0 ? along / size : vec2(1.0, 0.0);
      // The ends reach out by half the width, so that bends have no gaps.
      float end = float(gl_VertexID >> 1), side = float(gl_VertexID & 1) * 2.0 - 1.0;
      vec4 p = end > 0.5 ? b : a;
      vec2 off = side * vec2(-along.y, along.x) + (2.0 * end - 1.0) * along * 0.7;
      p.xy += off * width / pixels * p.w;
      p.z -= lift;
      gl_Position = p;
    }`,
    `#version 300 es
    precision highp float;
    uniform vec3 tint;
    out vec4 colour;
    ${SCREEN}
    void main() {
      colour = vec4(onScreen(tint), 1.0);
    }`,
  ];

  /** Width of lines, pixels of the page. */
  const LINE_WIDTH = 1.6;
  /** The part of its distance by which a line is lifted. */
  const LIFT = 1e-3;

  const program = (gl, [vertex, fragment]) => {
    const made = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(made, shader);
    }
    gl.linkProgram(made);
    if (!gl.getProgramParameter(made, gl.LINK_STATUS) && !gl.isContextLost()) throw new Error(gl.getProgramInfoLog(made));
    return { made, at: (name) => gl.getUniformLocation(made, name), slot: (name) => gl.getAttribLocation(made, name) };
  };

  class Renderer {
    constructor(gl, scene) {
      this.gl = gl;
      this.scene = scene;
      this.surface = program(gl, SURFACE);
      this.line = program(gl, LINE);
      this.parts = scene.meshes.map((mesh) => mesh.map((primitive) => this.upload(primitive)));
    }

    upload({ lines, colour, positions, normals, indices }) {
      const { gl } = this;
      const array = gl.createVertexArray();
      gl.bindVertexArray(array);
      const attribute = (slot, data) => {
        gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
        gl.enableVertexAttribArray(slot);
        gl.vertexAttribPointer(slot, 3, gl.FLOAT, false, 0, 0);
      };
      if (lines) {
        const ends = new Float32Array(3 * indices.length);
        indices.forEach((index, k) => ends.set(positions.subarray(3 * index, 3 * index + 3), 3 * k));
        gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ARRAY_BUFFER, ends, gl.STATIC_DRAW);
        ["from", "to"].forEach((name, k) => {
          const slot = this.line.slot(name);
          gl.enableVertexAttribArray(slot);
          gl.vertexAttribPointer(slot, 3, gl.FLOAT, false, 24, 12 * k);
          gl.vertexAttribDivisor(slot, 1);
        });
        return { lines, colour, array, count: indices.length / 2 };
      }
      attribute(this.surface.slot("position"), positions);
      attribute(this.surface.slot("normal"), normals);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
      return { lines, colour, array, count: indices.length };
    }

    draw(eye, time, ratio) {
      const { gl } = this;
      const { width, height } = gl.canvas;
      gl.viewport(0, 0, width, height);
      gl.clearColor(0, 0, 0, 0);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.enable(gl.DEPTH_TEST);
      const view = eye.view();
      for (const { mesh, matrix } of placed(this.scene, time)) {
        for (const part of this.parts[mesh]) {
          const use = part.lines ? this.line : this.surface;
          gl.useProgram(use.made);
          gl.uniformMatrix4fv(use.at("view"), false, view.matrix);
          gl.uniformMatrix4fv(use.at("model"), false, matrix);
          gl.uniform3fv(use.at("tint"), part.colour);
          gl.bindVertexArray(part.array);
          if (part.lines) {
            gl.uniform2f(use.at("pixels"), width, height);
            gl.uniform1f(use.at("width"), LINE_WIDTH * ratio);
            gl.uniform1f(use.at("lift"), view.lift * LIFT);
            gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, part.count);
          } else {
            for (const name of ["eye", "key", "fill"]) gl.uniform3fv(use.at(name), view[name]);
            gl.drawElements(gl.TRIANGLES, part.count, gl.UNSIGNED_INT, 0);
          }
        }
      }
    }
  }

  // ---- A model on a card ----

  /** How far a model turns when the pointer crosses a card, and when a key is pressed. */
  const [SWEEP, KEY_TURN] = [1.5 * Math.PI, Math.PI / 24];

  class Turning {
    constructor(stage, scene) {
      this.stage = stage;
      this.canvas = document.createElement("canvas");
      this.canvas.tabIndex = 0;
      this.canvas.setAttribute("role", "img");
      this.canvas.setAttribute("aria-label", `${stage.dataset.title}: drag or use the arrow keys to turn it`);
      this.canvas.title = "Drag to rotate, drag with Shift or the right button to pan, scroll or pinch to zoom, double-click to fit";
      this.gl = this.canvas.getContext("webgl2", { antialias: true });
      if (!this.gl) throw new Error("this browser has no WebGL2");
      const [azimuth, elevation] = stage.dataset.eye.split(",").map((degrees) => (degrees * Math.PI) / 180);
      this.eye = new Eye(extent(scene), azimuth, elevation);
      this.scene = scene;
      this.renderer = new Renderer(this.gl, scene);
      this.time = 0;
      this.playing = scene.duration > 0 && !matchMedia("(prefers-reduced-motion: reduce)").matches;
      this.pointers = new Map();
      this.touched = false;
      stage.append(this.canvas);
      this.listen();
      this.sizes = new ResizeObserver(() => this.resize());
      this.sizes.observe(this.canvas);
      this.canvas.focus({ preventScroll: true });
      this.redraw();
    }

    listen() {
      const { canvas, eye } = this;
      const on = (name, hear) =>
        canvas.addEventListener(name, (event) => {
          if (hear(event) !== false) event.preventDefault();
          this.touched = true;
          this.redraw();
        }, { passive: false });
      on("pointerdown", (event) => {
        canvas.setPointerCapture(event.pointerId);
        canvas.focus({ preventScroll: true });
        this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
      });
      on("pointermove", (event) => this.drag(event));
      for (const name of ["pointerup", "pointercancel"]) on(name, (event) => this.pointers.delete(event.pointerId));
      on("contextmenu", () => true);
      on("dblclick", () => eye.whole());
      // The page scrolls unless the model was taken hold of.
      on("wheel", (event) => {
        if (document.activeElement !== canvas) return false;
        const lines = event.deltaMode === 1 ? 16 : 1;
        const { clientWidth: width, clientHeight: height } = canvas;
        eye.zoom(Math.exp(clamp(event.deltaY * lines, -200, 200) * 0.002), [(event.offsetX - width / 2) / height, (height / 2 - event.offsetY) / height]);
      });
      const keys = {
        ArrowLeft: () => eye.turn(-KEY_TURN, 0), ArrowRight: () => eye.turn(KEY_TURN, 0), ArrowUp: () => eye.turn(0, -KEY_TURN), ArrowDown: () => eye.turn(0, KEY_TURN),
        "+": () => eye.zoom(0.9), "-": () => eye.zoom(1 / 0.9), Home: () => eye.whole(), " ": () => this.play(!this.playing), Escape: () => close(),
      };
      on("keydown", (event) => (event.ctrlKey || event.metaKey || event.altKey ? false : keys[event.key] ? keys[event.key]() : false));
      // A lost context comes back empty: the model is taken up again from its card.
      canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
      canvas.addEventListener("webglcontextrestored", () => {
        this.renderer = new Renderer(this.gl, this.scene);
        this.redraw();
      });
    }

    drag(event) {
      const before = this.pointers.get(event.pointerId);
      if (!before) return false;
      const { canvas, eye, pointers } = this;
      const now = [event.clientX, event.clientY];
      const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
      const { clientWidth: width, clientHeight: height } = canvas;
      const [x, y] = [now[0] - before[0], now[1] - before[1]];
      if (other) {
        const apart = (p) => Math.hypot(p[0] - other[0], p[1] - other[1]) || 1;
        eye.zoom(apart(before) / apart(now));
        eye.move((0.5 * x) / height, (-0.5 * y) / height);
      } else if (event.shiftKey || event.buttons & 6) {
        eye.move(x / height, -y / height);
      } else {
        eye.turn((x / width) * SWEEP, (y / width) * SWEEP);
      }
      pointers.set(event.pointerId, now);
    }

    play(playing) {
      this.playing = playing && this.scene.duration > 0;
      this.before = undefined;
      this.redraw();
      this.changed?.();
    }

    resize() {
      this.ratio = clamp(window.devicePixelRatio || 1, 1, 3);
      const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight].map((size) => Math.max(1, Math.round(size * this.ratio)));
      Object.assign(this.canvas, { width, height });
      this.eye.aspect = width / height;
      if (!this.touched) this.eye.whole();
      this.redraw();
    }

    redraw() {
      this.asked ??= requestAnimationFrame((now) => {
        this.asked = undefined;
        if (this.playing) {
          this.time = (this.time + (now - (this.before ?? now)) / 1000) % this.scene.duration;
          this.before = now;
        }
        if (!this.ratio) this.resize();
        if (!this.gl.isContextLost()) this.renderer.draw(this.eye, this.time, this.ratio);
        this.stage.dataset.state = "turning";
        if (this.playing) this.redraw();
      });
    }

    close() {
      this.sizes.disconnect();
      cancelAnimationFrame(this.asked);
      this.asked = 0;
      this.canvas.remove();
      this.gl.getExtension("WEBGL_lose_context")?.loseContext();
      this.stage.dataset.state = "picture";
    }
  }

  // ---- The page ----

  const scenes = new Map();
  let turning;

  /** Called by NAME.glb.js. */
  window.cyclideModel = (name, base64) => {
    const text = atob(base64);
    const bytes = new Uint8Array(text.length);
    for (let k = 0; k < text.length; k++) bytes[k] = text.charCodeAt(k);
    scenes.set(name, readGlb(bytes.buffer));
  };

  const load = (name) =>
    new Promise((done, fail) => {
      if (scenes.has(name)) return done(scenes.get(name));
      const script = document.createElement("script");
      script.src = `${name}.glb.js`;
      script.onload = () => (scenes.has(name) ? done(scenes.get(name)) : fail(new Error(`${name}.glb.js holds no model`)));
      script.onerror = () => fail(new Error(`${name}.glb.js is not beside this page`));
      document.head.append(script);
    });

  const close = () => {
    turning?.close();
    turning = undefined;
  };

  const open = async (stage) => {
    close();
    stage.dataset.state = "loading";
    try {
      const scene = await load(stage.dataset.model);
      close();
      turning = new Turning(stage, scene);
      const button = stage.querySelector(".play");
      button.hidden = scene.duration === 0;
      const name = () => (button.textContent = turning?.playing ? "Pause" : "Play");
      turning.changed = name;
      name();
    } catch (error) {
      stage.dataset.state = "failed";
      stage.querySelector(".note").textContent = `The model cannot be displayed: ${error.message}.`;
    }
  };

  const toHash = () => {
    const stage = document.getElementById(decodeURIComponent(location.hash.slice(1)))?.querySelector(".stage[data-model]");
    if (stage) open(stage);
  };

  for (const stage of document.querySelectorAll(".stage[data-model]")) {
    stage.dataset.state = "picture";
    stage.querySelector(".turn").addEventListener("click", () => open(stage));
    stage.querySelector(".back").addEventListener("click", close);
    stage.querySelector(".whole").addEventListener("click", () => {
      turning?.eye.whole();
      turning?.redraw();
    });
    stage.querySelector(".play").addEventListener("click", () => turning?.play(!turning.playing));
  }
  window.addEventListener("hashchange", toHash);
  toHash();
})();

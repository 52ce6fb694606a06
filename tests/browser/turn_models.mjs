// The gallery in a browser: every model is turned, moved, played and put back, from the file system.
//
// Run by hand after a change of the viewer, with a folder of the gallery and a Chromium; nothing else needs them.
//
//     npm install --prefix /tmp/browser playwright-core
//     NODE_PATH=/tmp/browser/node_modules node tests/browser/turn_models.mjs GALLERY /usr/bin/chromium
//
// Ends with a line `N models turned`, or with the first thing that is wrong.
import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { createRequire } from "node:module";
import path from "node:path";

const { chromium } = createRequire(path.join(process.env.NODE_PATH ?? ".", "_"))("playwright-core");
const [folder, executablePath] = process.argv.slice(2);
const address = `file://${path.resolve(folder)}/index.html`;
// A machine without a graphics card draws by its processor.
const args = ["--no-sandbox", "--disable-background-networking", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
const browser = await chromium.launch({ executablePath, args });
// Motions wait for `Play`: pictures taken of them can be compared.
const page = await browser.newPage({ viewport: { width: 1300, height: 1000 }, reducedMotion: "reduce" });
const complaints = [];
page.on("console", (message) => complaints.push(message.text()));
page.on("pageerror", (error) => complaints.push(error.message));
page.on("request", (request) => assert(request.url().startsWith("file:"), `${request.url()} is asked for`));
await page.goto(address);

// The ring of the focus comes with the first key.
await page.addStyleTag({ content: "canvas { outline: none !important; }" });

const stage = (name) => page.locator(`#${name} .stage`);
const state = (name) => stage(name).getAttribute("data-state");
const seen = async (name) => {
  await page.waitForTimeout(120);
  const picture = await stage(name).locator("canvas").screenshot();
  return createHash("sha256").update(picture).digest("hex");
};
const turn = async (name) => {
  await page.click(`#${name} .turn`);
  await page.waitForSelector(`#${name} .stage:is([data-state=turning], [data-state=failed])`);
  assert.equal(await state(name), "turning", await page.textContent(`#${name} .note`));
};

const names = await page.locator(".stage[data-model]").evaluateAll((stages) => stages.map((stage) => stage.dataset.model));
assert(names.length > 30);
let before;
for (const name of names) {
  await turn(name);
  if (before) assert.equal(await state(before), "picture", "one model is turned at a time");
  const first = await seen(name);
  await page.keyboard.press("ArrowLeft");
  assert.notEqual(await seen(name), first, `${name}: an arrow key turns it`);
  before = name;
}
assert.equal(await page.locator("canvas").count(), 1);

// A model turns about its middle and stays in the middle of the picture: margins on the left and right are equal but for perspective, a
// fortieth of the width here.
const margins = async (name) => {
  await page.waitForTimeout(120);
  const buttons = await page.addStyleTag({ content: ".stage > :not(canvas) { visibility: hidden !important; }" });
  const picture = (await stage(name).locator("canvas").screenshot()).toString("base64");
  await buttons.evaluate((style) => style.remove());
  return page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const { width, height } = image;
    const drawing = new OffscreenCanvas(width, height).getContext("2d");
    drawing.drawImage(image, 0, 0);
    const { data } = drawing.getImageData(0, 0, width, height);
    // The corners of the card are round.
    const edge = 10;
    const at = (x, y) => [0, 1, 2].map((k) => data[4 * (y * width + x) + k]);
    const ground = at(edge, edge);
    const differs = (x, y) => at(x, y).reduce((sum, value, k) => sum + Math.abs(value - ground[k]), 0) > 40;
    const filled = (x) => Array.from({ length: height - 2 * edge }, (_, y) => y + edge).some((y) => differs(x, y));
    const columns = Array.from({ length: width - 2 * edge }, (_, x) => x + edge).filter(filled);
    return [columns[0] / width, 1 - (columns.at(-1) + 1) / width];
  }, picture);
};
for (const name of ["torus_circles", "ring", "vase"]) {
  await turn(name);
  const card = await stage(name).boundingBox();
  const [x, y] = [card.x + card.width / 2, card.y + card.height / 2];
  for (const reach of [0, 60, 120]) {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + reach, y + reach / 3, { steps: 4 });
    await page.mouse.up();
    const [left, right] = await margins(name);
    assert(Math.abs(left - right) < 0.05, `${name}, dragged by ${reach}: margins ${left} and ${right}`);
  }
}

await turn("tee");
const box = await stage("tee").boundingBox();
const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
const gestures = {
  drag: async () => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 80, y - 30, { steps: 4 });
    await page.mouse.up();
  },
  "drag with Shift": async () => {
    await page.keyboard.down("Shift");
    await gestures.drag();
    await page.keyboard.up("Shift");
  },
  wheel: () => page.mouse.wheel(0, -300),
  "double click": () => page.mouse.dblclick(x, y),
};
// The buttons look otherwise below the pointer.
await page.mouse.move(x, y);
let shown = await seen("tee");
const first = shown;
for (const [name, make] of Object.entries(gestures)) {
  await make();
  const now = await seen("tee");
  assert.notEqual(now, shown, name);
  shown = now;
}
assert.equal(shown, first, "a double click shows the first view again");

// The page scrolls again when the model is let go of.
const scrolled = async () => {
  const from = await page.evaluate(() => scrollY);
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, 120);
  await page.waitForTimeout(400);
  return (await page.evaluate(() => scrollY)) !== from;
};
assert.equal(await scrolled(), false);
await page.evaluate(() => document.activeElement.blur());
assert.equal(await scrolled(), true);

await turn("pick_and_place");
const rest = await seen("pick_and_place");
assert.equal(await seen("pick_and_place"), rest);
await page.click("#pick_and_place .play");
await page.waitForTimeout(700);
assert.notEqual(await seen("pick_and_place"), rest, "the motion is played");
await page.focus("#pick_and_place canvas");
await page.keyboard.press("Escape");
assert.equal(await state("pick_and_place"), "picture");

// A link to a model opens it.
await page.goto("about:blank");
await page.goto(`${address}#vase`);
await page.waitForSelector("#vase .stage[data-state=turning]");

assert.deepEqual(complaints, []);
console.log(`${names.length} models turned`);
await browser.close();

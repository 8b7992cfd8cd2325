import { readFileSync } from "node:fs";
import { type Download, expect, type Locator, type Page, test } from "@playwright/test";
import { ALL_FORMATS, BufferSource, Input } from "mediabunny";
import { documentOf, drop, open, pause, pointAt, watchErrors } from "./page";

test.setTimeout(400_000); // a thousand by a thousand pixels, sixty times, without a graphics card
const DRAWN = { timeout: 300_000 };

async function filming(page: Page): Promise<Locator> {
  await page.getByRole("button", { name: "Export" }).click();
  const panel = page.getByRole("dialog", { name: /^Take .* with you$/ });
  await panel.getByRole("button", { name: "Film", exact: true }).click();
  await expect(panel.getByRole("img", { name: "How it will look" })).toBeVisible();
  await panel.getByLabel("Lasts").fill("2");
  return panel;
}

async function made(panel: Locator): Promise<void> {
  await panel.getByRole("button", { name: "Make the film" }).click();
  await expect(panel.getByRole("button", { name: /^Save / })).toBeVisible(DRAWN);
}

async function saved(page: Page, panel: Locator): Promise<Download> {
  const [download] = await Promise.all([page.waitForEvent("download"), panel.getByRole("button", { name: /^Save / }).click()]);
  return download;
}

/** What a reader of films says of one. */
async function read(download: Download) {
  const input = new Input({ source: new BufferSource(readFileSync(await download.path())), formats: ALL_FORMATS });
  const track = await input.getPrimaryVideoTrack();
  if (!track) throw new Error("no video");
  const { packetCount, averagePacketRate } = await track.computePacketStats();
  const { codec, displayWidth, displayHeight } = track;
  const seconds = Math.round(100 * (await track.computeDuration())) / 100;
  const audio = await input.getPrimaryAudioTrack();
  const sound = audio && { codec: audio.codec, seconds: Math.round(await audio.computeDuration()) };
  return { codec, size: [displayWidth, displayHeight], frames: packetCount, fps: Math.round(averagePacketRate), seconds, sound };
}

/** A second of a tone. */
function wav(): Buffer {
  const rate = 8000;
  const bytes = Buffer.alloc(44 + rate, 128);
  bytes.write("RIFF", 0);
  bytes.writeUInt32LE(36 + rate, 4);
  bytes.write("WAVEfmt ", 8);
  bytes.writeUInt32LE(16, 16);
  bytes.writeUInt16LE(1, 20);
  bytes.writeUInt16LE(1, 22);
  bytes.writeUInt32LE(rate, 24);
  bytes.writeUInt32LE(rate, 28);
  bytes.writeUInt16LE(1, 32);
  bytes.writeUInt16LE(8, 34);
  bytes.write("data", 36);
  bytes.writeUInt32LE(rate, 40);
  for (let k = 0; k < rate; k++) bytes[44 + k] = 128 + Math.round(60 * Math.sin((2 * Math.PI * 440 * k) / rate));
  return bytes;
}

/** The film in the panel as the browser decodes it, at some seconds: a few colours of each moment, with their alpha. */
function seen(film: Locator, times: readonly number[]) {
  return film.evaluate(async (playing: HTMLVideoElement, times) => {
    const video = document.createElement("video"); // one of our own: that in the panel plays in a loop
    const loaded = new Promise((resolve) => video.addEventListener("loadeddata", resolve, { once: true }));
    Object.assign(video, { muted: true, preload: "auto", src: playing.src });
    await loaded;
    const frames: { corner: number; middle: number; colours: number; pixels: number[] }[] = [];
    for (const time of times) {
      const there = new Promise((resolve) => video.addEventListener("seeked", resolve, { once: true }));
      video.currentTime = time;
      await there;
      const canvas = new OffscreenCanvas(60, 60);
      const context = canvas.getContext("2d")!;
      context.drawImage(video, 0, 0, 60, 60);
      const { data } = context.getImageData(0, 0, 60, 60);
      const words = new Uint32Array(data.buffer);
      frames.push({ corner: data[3]!, middle: data[4 * (60 * 32 + 30) + 3]!, colours: new Set(words).size, pixels: [...data] });
    }
    return frames;
  }, times);
}

/** How many pixels are of another colour, as a share. */
function difference(a: readonly number[], b: readonly number[]): number {
  let other = 0;
  for (let k = 0; k < a.length; k += 4) if ([0, 1, 2].some((c) => Math.abs(a[k + c]! - b[k + c]!) > 24)) other++;
  return (4 * other) / a.length;
}

test("a film is an MP4 of 30 frames a second, and the page is as it was", async ({ page }) => {
  const errors = watchErrors(page);
  await open(page);
  await pause(page);
  await page.getByRole("slider", { name: "Frame" }).fill("20");
  const canvas = page.locator(".view3d canvas");
  const sizeOf = () => canvas.evaluate(({ width, height }: HTMLCanvasElement) => [width, height]);
  const before = { dot: await pointAt(page, "Top"), size: await sizeOf(), document: await documentOf(page) };
  const panel = await filming(page);
  await made(panel);
  expect(await sizeOf()).toEqual(before.size);
  const after = await pointAt(page, "Top");
  expect(Math.hypot(after.x - before.dot.x, after.y - before.dot.y)).toBeLessThan(3);
  expect(await page.evaluate(() => rigless?.frame)).toBe(20);
  expect(await documentOf(page)).toEqual(before.document);
  const download = await saved(page, panel);
  expect(download.suggestedFilename()).toBe("Cactus.mp4");
  expect(await read(download)).toEqual({ codec: "avc", size: [1080, 1080], frames: 60, fps: 30, seconds: 2, sound: null });
  const [first, later] = await seen(panel.getByLabel("The film"), [0.02, 1.2]);
  expect(first!.colours).toBeGreaterThan(100);
  expect(later!.colours).toBeGreaterThan(100);
  expect(difference(first!.pixels, later!.pixels)).toBeGreaterThan(0.02);
  await panel.getByRole("button", { name: "Close" }).click();
  await expect(page.getByRole("heading", { name: /^Cactus\.mp4 is / })).toBeVisible();
  expect(errors).toEqual([]);
});

test("a WebM may be transparent, shows the model alone, and is heard", async ({ page }) => {
  const errors = watchErrors(page);
  await open(page);
  await drop(page, [{ name: "noise.mp3", bytes: Buffer.from("no song") }]);
  await expect(page.getByText("noise.mp3 cannot be played by this browser.")).toBeVisible();
  await drop(page, [{ name: "tone.wav", bytes: wav() }]);
  await expect(page.getByText("tone.wav plays with the dance.")).toBeVisible();
  const panel = await filming(page);
  await panel.getByRole("button", { name: "Cactus", exact: true }).click();
  await panel.getByRole("button", { name: "Transparent" }).click();
  await expect(panel.getByRole("button", { name: "WebM" })).toHaveAttribute("aria-pressed", "true");
  await made(panel);
  const download = await saved(page, panel);
  expect(download.suggestedFilename()).toBe("Cactus.webm");
  expect(await read(download)).toMatchObject({
    codec: "vp9",
    size: [1080, 1080],
    frames: 60,
    seconds: 2,
    sound: { codec: "opus", seconds: 2 },
  });
  for (const { corner, middle, colours } of await seen(panel.getByLabel("The film"), [0.02, 1.2])) {
    expect(corner).toBe(0);
    expect(middle).toBe(255);
    expect(colours).toBeGreaterThan(100);
  }
  expect(errors).toEqual([]);
});

test("a film that is called off leaves nothing", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await open(page);
  const panel = await filming(page);
  let downloads = 0;
  page.on("download", () => downloads++);
  await panel.getByRole("button", { name: "Make the film" }).click();
  const progress = panel.getByRole("progressbar", { name: "Making the film" });
  await expect.poll(async () => Number(await progress.getAttribute("aria-valuenow")), DRAWN).toBeGreaterThan(2);
  await panel.getByRole("button", { name: "Cancel" }).click();
  await expect(progress).toBeHidden();
  await expect(panel.getByRole("button", { name: "Make the film" })).toBeEnabled();
  await expect(panel.getByRole("button", { name: /^Save / })).toHaveCount(0);
  await expect(panel.getByRole("img", { name: "How it will look" })).toBeVisible();
  await panel.getByRole("button", { name: "Close" }).click();
  await expect(page.locator(".view3d canvas")).toBeVisible();
  const frame = await page.evaluate(() => rigless?.frame);
  await expect.poll(() => page.evaluate(() => rigless?.frame)).not.toBe(frame); // it plays on
  expect(downloads).toBe(0);
});

test("a browser that encodes no video makes a GIF, and any makes a picture", async ({ page }) => {
  const errors = watchErrors(page);
  await page.addInitScript(() => Reflect.deleteProperty(globalThis, "VideoEncoder"));
  await open(page);
  const panel = await filming(page);
  await expect(panel.getByRole("group", { name: "Kind" }).getByRole("button")).toHaveText(["GIF"]);
  await expect(panel.getByRole("button", { name: "Transparent" })).toBeDisabled();
  await panel.getByRole("button", { name: "Upright" }).click();
  await panel.getByRole("button", { name: "Goes around" }).click();
  await made(panel);
  const download = await saved(page, panel);
  expect(download.suggestedFilename()).toBe("Cactus.gif");
  const gif = readFileSync(await download.path());
  expect(gif.subarray(0, 6).toString()).toBe("GIF89a");
  expect([gif.readUInt16LE(6), gif.readUInt16LE(8)]).toEqual([360, 640]);
  const frames = await panel.getByRole("img", { name: "The film" }).evaluate(async (image: HTMLImageElement) => {
    const decoder = new ImageDecoder({ data: await (await fetch(image.src)).arrayBuffer(), type: "image/gif" });
    await decoder.tracks.ready;
    await decoder.completed;
    const { frameCount } = decoder.tracks.selectedTrack!;
    const shown: number[][] = [];
    let length = 0;
    for (let k = 0; k < frameCount; k++) {
      const { image: frame } = await decoder.decode({ frameIndex: k });
      length += frame.duration ?? 0;
      const canvas = new OffscreenCanvas(36, 64);
      const context = canvas.getContext("2d")!;
      context.drawImage(frame, 0, 0, 36, 64);
      if (k % 29 === 0) shown.push([...context.getImageData(0, 0, 36, 64).data]);
      frame.close();
    }
    return { frameCount, seconds: length / 1e6, shown };
  });
  expect([frames.frameCount, frames.seconds]).toEqual([60, 2]);
  expect(difference(frames.shown[0]!, frames.shown[1]!)).toBeGreaterThan(0.02);

  const [picture] = await Promise.all([
    page.waitForEvent("download"),
    panel.getByRole("button", { name: "A picture of this frame" }).click(),
  ]);
  expect(picture.suggestedFilename()).toBe("Cactus.png");
  const png = readFileSync(await picture.path());
  expect([png.readUInt32BE(16), png.readUInt32BE(20)]).toEqual([1080, 1920]);
  expect(png.length).toBeGreaterThan(50_000);
  expect(errors).toEqual([]);
});

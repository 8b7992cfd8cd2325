import type { Sound } from "../app/ports";

/** A song as the browser plays it, at any speed with its own pitch. Errors: it cannot be decoded. */
export async function openSound(bytes: Uint8Array): Promise<Sound> {
  const audio = new Audio();
  const url = URL.createObjectURL(new Blob([bytes as Uint8Array<ArrayBuffer>]));
  const listening = new AbortController();
  const { signal } = listening;
  const close = (): void => {
    listening.abort();
    audio.pause();
    URL.revokeObjectURL(url);
  };
  try {
    await new Promise((resolve, reject) => {
      audio.addEventListener("loadedmetadata", resolve, { signal });
      audio.addEventListener("error", () => reject(new Error("It cannot be decoded.")), { signal });
      audio.preload = "auto";
      audio.loop = true;
      audio.src = url;
    });
  } catch (error) {
    close();
    throw error;
  }
  // A page that is not seen does not dance.
  document.addEventListener("visibilitychange", () => document.hidden && audio.pause(), { signal });
  return {
    seconds: audio.duration,
    get playing() {
      return !audio.paused;
    },
    get at() {
      return audio.currentTime;
    },
    play(at, speed) {
      audio.currentTime = at;
      audio.playbackRate = speed;
      void audio.play().catch(() => undefined); // before the first click a page may make no sound: the next frame asks again
    },
    stop: () => audio.pause(),
    close,
  };
}

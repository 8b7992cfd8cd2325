// Puts everything together: the app with the ports of a page, the elements that show it, and the stage.

import { Session } from "./app/session";
import { ports } from "./page/ports";
import { App } from "./ui/app";
import { Viewport } from "./viewport/viewport";

/** So long after the first dance there is time for what may be needed later. */
const LATER_MS = 5_000;

const app = new App();
const session = new Session(ports);
app.session = session;
app.buildStage = (host) => new Viewport(host);
document.body.prepend(app);
addEventListener("hashchange", () => location.reload()); // a link that is pasted where Rigless is open already
const stop = session.context.workspace.on("performance", () => {
  stop();
  setTimeout(() => void import("./page/offline").then(({ prepareOffline }) => prepareOffline(session)).catch(() => undefined), LATER_MS);
});

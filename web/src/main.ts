// Puts everything together: the app with the ports of a page, the elements that show it, and the stage.

import { Session } from "./app/session";
import { fetchAhead } from "./fetch-ahead";
import { ports } from "./page/ports";
import { App } from "./ui/app";
import { Viewport } from "./viewport/viewport";

const app = new App();
app.session = new Session(ports);
app.buildStage = (host) => new Viewport(host);
document.body.prepend(app);
addEventListener("hashchange", () => location.reload()); // a link that is pasted where Rigless is open already
fetchAhead();

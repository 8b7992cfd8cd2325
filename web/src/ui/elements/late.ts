// What nobody sees before they ask for it: not part of the first load.

import "./clip-chooser";
import "./drop-overlay";
import "./export-panel";
import "./help";
import "./job-card";
import "./menu";
import "./panel-model";
import "./panel-motion";
import "./panel-points";
import "./panel-poses";
import "./prompt";
import "./take";
import "./views";

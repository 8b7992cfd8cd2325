// Entry of the page's worker.

import { serve } from "./serve";
import type { ServerPort } from "./serve";

serve(globalThis as unknown as ServerPort);

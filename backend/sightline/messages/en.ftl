# What Sightline says, in English: screens, errors, notes, report and command line. The language of the source;
# other languages are files beside this one. Keys are kebab-case, `area-what`; values carry their unit in their
# name. Marked parts: <strong>, <em>, <kbd>, <code>, <sub>, and those that a screen gives a meaning (<link>).


## Words of the domain: targets, and where to click each

target-roof = Roof
target-driver_eye = Driver’s eye
target-taillight = Taillight
target-headlight = Headlight
target-other = Other
target-noun-roof = roof
target-noun-driver_eye = driver’s eye
target-noun-taillight = taillight
target-noun-headlight = headlight
target-noun-other = other
target-hint-roof = the near edge of the roof at its highest point
target-hint-driver_eye = the driver’s eye
target-hint-taillight = the bottom edge of the lit taillight
target-hint-headlight = the bottom edge of the headlight
target-hint-other = the point whose height you want

not-visible-hidden = hidden by another vehicle
not-visible-glare = glare
not-visible-too_dark = too dark
not-visible-outside = outside the frame
not-visible-own_body = hidden by its own body
not-visible-no_driver = no driver seen
direction-right = to the right
direction-left = to the left
side-near = near side
side-far = far side
inset-near-edge = near edge
inset-crown = crown
inset-roof_car = Roof, cars
inset-roof_van = Roof, vans
inset-roof_box = Roof, lorries and buses
inset-roof_unknown = Roof, no class
inset-driver_eye_near = Driver’s eye, near side
inset-driver_eye_far = Driver’s eye, far side

## Words of the domain: how traffic goes at a site

traffic-title = Traffic and camera
traffic-help = With each vehicle’s direction, these settings determine whether its driver sits on the camera side (near) or the far side. Without them, no eye height can be computed.
traffic-not-said = Not set
traffic-side = Traffic keeps
traffic-right = right
traffic-left = left
traffic-steering = Steering wheel usually
wheel-left = on the left
wheel-right = on the right
traffic-camera = Camera position
place-title = Place and road
place-latitude = Latitude (WGS84)
place-longitude = Longitude
place-coordinates-problem = Enter coordinates in decimal degrees, for example 49.44315 and 1.09932. South and west are negative.
place-road = Road class
place-roads = motorway; dual carriageway; single carriageway, rural; urban arterial; urban street; local road
place-lane = Lane measured
place-lanes = lane 1, next to the verge; lane 2; both lanes; all lanes of one direction
place-travel = Travel direction
place-travel-example = towards Rouen, northbound
place-limit = Speed limit
place-limit-is = limit { $limit }
place-limit-problem = Enter the speed limit as a number of { $unit }.
place-lamps = Street lighting
place-lamps-present = present
place-lamps-none = none
place-lamps-are = { $lamps ->
    [present] street lighting
   *[none] no street lighting
}
place-not-said = Not set
place-zone = Time zone
place-zone-hint = Example: Europe/Paris. Suggested for each recording.
camera-verge = on the verge
camera-median = in the median

asked-title = Targets to measure
asked-help = A vehicle is complete when each of these targets is measured or marked as not visible.
asked-none = Choose at least one target by day and one in low light.

## Words of the domain: states of vehicles, measurements, recordings, jobs, calibrations, people

state-to_do = to do
state-partial = partly measured
state-measured = measured
state-not_visible = not visible
state-out_of_sample = outside the sample
state-discarded = discarded
state-to_review = to review
state-accepted = accepted
state-fixed = fixed
state-rejected = rejected
state-reopened = reopened
state-withdrawn = withdrawn
state-not_measurable = not measurable
state-done = done
state-next = next
state-begun = in progress
state-waiting = waiting
state-ingesting = importing
state-ready = ready
state-failed = failed
state-queued = queued
state-running = running
state-cancelled = cancelled
state-trusted = reliable
state-not_trusted = unreliable
state-used = used
state-left_out = excluded
state-active = active
state-inactive = deactivated

## Words of the domain: light and kinds of vehicles

lighting-daytime = Daytime
lighting-low_light = Low light
lighting-noun-daytime = daytime
lighting-noun-low_light = low light
category-hatchback = Hatchback
category-saloon = Saloon
category-estate = Estate
category-suv = SUV
category-multi_purpose = Multi-purpose vehicle
category-pickup = Pick-up
category-van = Van
category-lorry = Lorry
category-tractor_unit = Tractor unit
category-bus = Bus
category-recreational_vehicle = Recreational vehicle
category-trailer = Trailer or caravan
category-motorcycle = Motorcycle
category-other = Other

## Sets of classes of vehicles

class-set-passenger_cars = Passenger cars
class-set-light_trucks = Light trucks and multi-purpose vehicles
class-set-heavy = Heavy vehicles
class-set-none = no set
class-choice = Classes
discarded-no_vehicle = discarded: no vehicle
discarded-twice = discarded: duplicate
discarded-cut_off = discarded: cut off by the recording
discarded-stopped = discarded: stopped or turning
discarded-other = discarded: other reason (see notes)
sample-title = Sample
sample-edit = Change the sample
sample-dialog = Passes to measure
sample-method = Passes
sample-method-help = The rule uses the pass number, so a pass found later does not change which others are selected. Passes that are not selected are marked “outside the sample”.
sample-every = every pass
sample-nth = every n-th pass
sample-share = a random share (seeded)
sample-step = n
sample-step-problem = Enter a whole number from 2 to 1000.
sample-start = First number
sample-start-problem = Enter a whole number from 1 to n.
sample-share-percent = Share
sample-share-problem = Enter more than 0 and at most 100 %.
sample-seed = Seed
sample-seed-problem = Enter a whole number.
sample-free = Free-flowing vehicles: minimum headway
sample-free-help = Per direction, from the start of one pass to the start of the next. Empty: all vehicles. 5 s is usual.
sample-free-problem = Enter seconds, more than 0 and at most 60.
sample-quotas = Quotas
sample-quotas-help = Number of vehicles wanted of each kind. Empty: no quota. Progress is shown beside the passes while you measure.
sample-quota-problem = Enter a whole number, 1 or more.
sample-quota = { NUMBER($measured) } of { NUMBER($wanted) }
sample-any-class = any class
sample-response = Outcome of the passes
sample-lighting = Lighting
sample-of = Vehicles or target
sample-passes = Passes
sample-discarded = Discarded
sample-out = Outside
sample-measured = Measured
sample-unseen = Not visible
sample-outside = { $counts ->
    [yes] { $count ->
        [one] { NUMBER($count) } pass outside the sample was measured and counts in the results.
       *[other] { NUMBER($count) } passes outside the sample were measured and count in the results.
    }
   *[no] { $count ->
        [one] { NUMBER($count) } pass outside the sample was measured and does not count in the results.
       *[other] { NUMBER($count) } passes outside the sample were measured and do not count in the results.
    }
}
sample-outside-counts = Heights measured outside the sample count in the results
sample-outside-counts-help = Usually off: these vehicles were not chosen by the sampling rule. Applies to every page, package, report and study.
sample-open = Open
sample-rate = Response
sample-all = All
sample-unknown = unknown
sample-vehicles = All vehicles
sample-help = Response: passes measured divided by passes in the sample, with the exact 95 % interval. If it differs between groups, the measured vehicles may not represent the traffic.
sample-rule = { $method ->
    [nth] One pass in { NUMBER($step) } is measured, starting with number { NUMBER($start) }.
    [share] A random share of { $share } % of the passes is measured (seed { $seed }).
   *[every] Every pass is measured.
}
sample-rule-free = Only vehicles with a headway of at least { $seconds } s.
class-choice-any = all classes
class-choice-help = Vehicle sets and classes to include. None selected: all.
class-choice-sets = Sets
class-choice-classes = Classes
checklist-all = All
classes-open = Classes
classes-title = Vehicle classes
classes-help = Sets limit statistics, quotas and packages; the package also names the legal classes. A change applies to existing measurements too, because a vehicle’s set follows from its class.
classes-class = Class
classes-set = Set
classes-set-of = Set of { $category }
classes-eu = EU
classes-eu-of = EU classes of { $category }
classes-eu-problem = Enter EU classes: L, M1 to M3, N1 to N3, O1 to O4 or T.
classes-fhwa = FHWA
classes-fhwa-of = FHWA classes of { $category }
classes-fhwa-problem = Enter numbers from 1 to 13, for example “5 6 7” or “8-13”.

## Roles of people

role-viewer = Viewer
role-operator = Operator
role-reviewer = Reviewer
role-admin = Administrator
role-manager = Manager

## Pages: their names in the rail, the window's title and links

page-sign-in = Sign in
page-surveys = Surveys
page-survey = Overview
page-planning = Plan the site
page-camera = Camera
page-recordings = Recordings
page-pose = Road
page-measure = Measure
page-checks = Checks
page-review = Review
page-lots = Lots
page-repeats = Repeatability
page-click-again = Click again
page-scans = Line scans
page-scan-results = Motion
page-scan = Line scan
page-live = Live
page-export = Package
page-statistics = Results
page-sight-distance = Sight distance
page-studies = Studies
page-study = Study
page-catalogue = Catalogue
page-audit = Audit
page-history = History
page-settings = Settings
page-people = People
page-jobs = Jobs
page-system = System
page-account = Account
page-guide = Guide

## Commands: buttons, menus and the list of keys

command-help = Show the keyboard shortcuts
command-frameNext = Next frame
command-framePrevious = Previous frame
command-frameNextTen = Ten frames forward
command-framePreviousTen = Ten frames back
command-secondNext = One second forward
command-secondPrevious = One second back
command-frameFirst = First frame
command-frameLast = Last frame
command-frameGo = Go to a frame
command-play = Play or pause
command-loupe = Magnifier (hold)
command-loupeToggle = Magnifier on or off
command-linesToggle = Show or hide the lines
command-brightToggle = Brighten the image (display only)
command-cursor = Keyboard cursor on or off
command-place = Place the point at the cursor
command-zoomIn = Zoom in
command-zoomOut = Zoom out
command-zoomFit = Fit the frame
command-passNext = Next pass
command-passPrevious = Previous pass
command-target1 = Target: roof
command-target2 = Target: driver’s eye
command-target3 = Target: taillight
command-target4 = Target: headlight
command-target5 = Target: other
command-notVisible = Mark the target as not visible
command-newContact = New contact point
command-secondFrame = Add a second frame
command-followPass = Follow through the pass
command-proposeContact = Suggest the tyre contact at the pointer
command-driverSide = Change the driver’s side (near or far)
command-selectNext = Next point
command-bestFrame = Best frame of the pass
command-record = Go to make and model
command-recentModel1 = Recently used model 1
command-recentModel2 = Recently used model 2
command-recentModel3 = Recently used model 3
command-recentModel4 = Recently used model 4
command-whichModel = Go to the models that fit
command-passBegin = Mark the first frame of a pass or the board
command-passEnd = Mark the last frame of a pass or the board
command-passSplit = Split the pass before this frame
command-passJoin = Join the pass with the next one
command-passDiscard = Discard the pass
command-confirmNext = Next unfinished pass
command-undo = Undo
command-redo = Redo
command-remove = Withdraw the selected measurement
command-cancel = Deselect or cancel
command-nudgeLeft = Move the point left 1 px
command-nudgeRight = Move the point right 1 px
command-nudgeUp = Move the point up 1 px
command-nudgeDown = Move the point down 1 px
command-nudgeLeftFar = Move the point left 10 px
command-nudgeRightFar = Move the point right 10 px
command-nudgeUpFar = Move the point up 10 px
command-nudgeDownFar = Move the point down 10 px
command-nudgeLeftFine = Move the point left 0.1 px
command-nudgeRightFine = Move the point right 0.1 px
command-nudgeUpFine = Move the point up 0.1 px
command-nudgeDownFine = Move the point down 0.1 px
command-scanFit = Fit the vehicle to the window
command-scanTaller = Stretch vertically
command-scanFlatter = Compress vertically
command-scanWheels = Click both wheels for the wheelbase
command-scanNew = Add a vehicle by its front and rear
command-scanHeight = Measure heights by contact and target
command-scanRod = Calibrate heights with a rod
command-reviewAccept = Accept
command-reviewReject = Reject
command-reviewFix = Fix
command-reviewNext = Next measurement
command-reviewPrevious = Previous measurement
command-reviewReason1 = Rejection reason 1
command-reviewReason2 = Rejection reason 2
command-reviewReason3 = Rejection reason 3
command-reviewReason4 = Rejection reason 4
command-reviewReason5 = Rejection reason 5
command-reviewReason6 = Rejection reason 6

## Keys, as keycaps show them

key-Ctrl = Ctrl
key-Alt = Alt
key-Shift = Shift
key-Space = Space
key-Enter = Enter
key-Tab = Tab
key-Backspace = Backspace
key-Home = Home
key-End = End
key-Delete = Del
key-Escape = Esc
key-PageUp = PgUp
key-PageDown = PgDn

## Where keys listen

scope-anywhere = Everywhere
scope-frames = Frames
scope-measure = Measurement
scope-point = A selected point
scope-scan = Line scan
scope-review = Review

## Times, lengths, and what went wrong

table-actions = Actions
time-just-now = just now
time-minutes-ago = { $minutes } min ago
time-today = today { $time }
length-problem = Enter a length, for example { $example }.
problem-server = Server error (status { $status }). Try again. If the error continues, contact your administrator.
problem-refused = The server refused this (status { $status }).
problem-stopped = Stopped.
problem-page = Something went wrong in this page. Reload it; if it happens again, contact your administrator.
problem-offline = The server cannot be reached.
problem-unreachable = The server could not be reached, so this was not saved. Check the connection and try again.
problem-unreadable = The answer of the server could not be read, so it is not known whether this was saved. Try again.
keys-reserved = { $chord } is reserved by the browser; choose another key.

## Addresses of things that are not there

address-elsewhere = { $what ->
    [vehicle] This link points to a vehicle that is not in this survey, or was deleted.
    [measurement] This link points to a measurement that is not in this survey, or was withdrawn.
    [recording] This link points to a recording that is not in this survey, or cannot be shown.
    [camera] This link points to a camera that is not in this survey; another is shown.
   *[scan] This link points to a line-scan recording that is not in this survey.
}

## Components: progress, undo

loading = Loading { $what }…
job-queued = Queued
job-named = { $job }: { $words }
undo-step = Undo: { $step }
undo-nothing = Nothing to undo
redo-step = Redo: { $step }
redo-nothing = Nothing to redo
undo-done = Undone: { $step }.
redo-done = Redone: { $step }.

## Guide

guide-pages = Pages of the guide
guide-loading = the guide
guide-page-first-survey = First survey
guide-page-field-protocol = Field protocol
guide-page-operator = Operator
guide-page-reviewer = Reviewer
guide-page-standards-engineer = Standards engineer
guide-page-administrator = Administrator
guide-page-access = Who may do what
guide-page-studies = Studies
guide-page-CONVENTIONS = Method
guide-page-formats = Formats
guide-page-glossary = Glossary

## Jobs of the server, done once more

jobs-only-failed-again = { $state ->
    [queued] This job is still queued
    [running] This job is running
   *[done] This job has finished
 }; only failed or stopped jobs can be run again.
jobs-restart-elsewhere = Restart this job ({ $kind }) on the page of its recording, where its files are checked too.

## System: the page of administrators

system-lead = Current state of this installation. Prometheus reads the same figures on a separate port.
system-loading = the state of the system
system-program = Software and server
system-version = Version
system-answered = This server
system-answered-by = { $host }, process { $process }
system-database = Database
system-database-of = { $kind ->
    [sqlite] SQLite
   *[other] PostgreSQL
  }, { $count ->
    [one] 1 connection in use
   *[other] { NUMBER($count) } connections in use
  }
system-media = Videos and images
system-free = Free on the disk
system-memory = Memory of the server
system-unknown = not available
system-decoder = Still-image decoder
system-decoder-none = idle
system-decoder-runs = process { $process }
system-waiting = Queued
system-waiting-of = { $reading } reads, { $writing } writes
system-clock = Clock
system-clock-back = The clock went back by { $seconds } s, noticed on { $when }. Synchronise it with a time server (NTP); times recorded around then may be out of order.
system-jobs = Jobs
system-checkpoints = Checkpoints
system-checkpoints-sign = Sign a checkpoint
system-checkpoints-lead = A checkpoint signs where every audit chain ends. Keep the files outside this server: they reveal a chain that is cut or rewritten later. Every package is signed in the same way.
system-checkpoints-loading = the checkpoints
system-checkpoints-key = Current key
system-checkpoints-keys-before = { $count ->
    [one] It replaced { NUMBER($count) } earlier key, which signed it.
   *[other] It replaced { NUMBER($count) } earlier keys; each signed the next.
  }
system-checkpoints-none = No checkpoints yet
system-checkpoints-chains = Chains
system-checkpoints-events = Events
system-checkpoints-root = Root
system-checkpoints-download = Download
system-checkpoints-download-of = Download the checkpoint of { $when }
system-licences = Libraries and licences
system-licences-show = Show
system-licences-hide = Hide
system-licences-loading = the libraries
system-licences-server = Library of the server
system-licences-pages = Library of the pages
system-licences-version = Version
system-licences-licence = Licence
system-licences-none = none stated

## Jobs: the page

own-name-title = What is your name?
own-name-why = It is shown beside everything that you measure, review or change.
own-name = Your name
jobs-lead = Long-running tasks of the server: queued, running and finished.
jobs-loading = the jobs
jobs-show = Show
jobs-all = All
jobs-none-title = No jobs
jobs-none = Video imports, pass searches, poses, calibrations and packages are listed here.
jobs-kind = { $kind ->
    [ingest] Video import
    [passes] Pass search
    [proposals] Suggested points
    [pose] Camera pose
    [calibrate] Calibration
    [drift] Camera stability check
    [export] Package
    [scan_read] Strip import
    [scan_find] Vehicle search in strips
    [tidy] File clean-up
    [demonstration] Demonstration survey
    [demonstration_study] Demonstration study (simulated)
    [study] Study
    [compute_again] Computing heights again
   *[other] Other job
}
jobs-column-what = Job
jobs-column-for = For
jobs-column-state = State
jobs-column-said = Message
jobs-column-begun = Started
jobs-again = Run again
jobs-begun-again = The job was started again.

## App: titles, the bar above, the rail, addresses that lead nowhere

app-name = Sightline
app-title = { $page } – Sightline
app-title-in-survey = { $page } – { $survey } – Sightline
app-not-found = Not found
app-skip = Skip to the page
app-skip-picture = Skip to the image
app-to-surveys = Go to Surveys
app-nothing-here-title = Page not found
app-nothing-here = The link may be out of date, or the survey may have been removed.
app-not-loaded = This page could not be loaded. A newer version may have been installed; reload the page.
app-where = Current location
app-survey = Survey
app-other-step = { $page }: go to another step
app-pages = Pages of Sightline
app-admin = Admin
rail-setup = Set up
rail-measure = Measure
rail-quality = Quality
rail-results = Results
app-keys = Keyboard shortcuts
app-work = Survey steps
save-waiting = { NUMBER($count) } not yet saved
save-pending = saving…
save-failed = last change not saved
save-done = saved { $time }
menu-person = { $person }: account
menu-role = { $role } · Sightline { $version }
menu-theme = Theme
menu-theme-system = System
menu-theme-light = Light
menu-theme-dark = Dark
menu-lengths = Lengths
menu-lengths-m = Metres
menu-lengths-ft = Feet
menu-sign-out = Sign out

## App: while the server cannot be reached

offline-kept = { $count ->
    [one] { NUMBER($count) } change is kept in this browser and will be saved when the connection is back.
   *[other] { NUMBER($count) } changes are kept in this browser and will be saved when the connection is back.
}
offline-changes = { $count ->
    [one] { NUMBER($count) } change will be saved when the connection is back; keep this page open.
   *[other] { NUMBER($count) } changes will be saved when the connection is back; keep this page open.
}
offline-next = Retrying in { $seconds } s.
offline-now = Retrying…
offline-try = Retry now

## App: what was refused, or changed by somebody else meanwhile

unsaved-refused = <link>{ $what }</link>: { $problem } Yours: { $mine }.
unsaved-conflict = <link>{ $what }</link>: { $problem } Yours: { $mine }. Theirs: { $theirs }.
unsaved-take = Take theirs
unsaved-keep = Keep mine
unsaved-again = Try again
unsaved-drop = Discard
unsaved-otherwise = The server stored a different value; check it.

## App: the list of keys

keys-how = To change a key, click it and press the new one. Keys are saved in this browser.
keys-usual = Reset to defaults
keys-clash = { $chord } is now assigned to both “{ $one }” and “{ $other }”; the first one applies.
keys-elsewhere = On other screens
keys-wheel = Wheel: zoom at the pointer. Drag with the middle button, or with Space held: move the image.
keys-of = { $command }: { $keys }. Change
keys-change = Change the key
keys-press = press a key…

## Boards: the kind of a board and its markers

board-kind = Kind of board
board-checkerboard = Checkerboard
board-charuco = ChArUco
board-dictionary = Dictionary
board-marker = Marker side
board-marker-problem = Enter the side of the black marker, for example { $example }.
board-marker-too-large = The marker must be smaller than its square.

## Did the camera move

drift-title = Camera stability
drift-stopped = The check stopped.
drift-under-way = Checking camera stability…
drift-not-yet = Camera stability not checked.
drift-holds = Pose kept by { $person }: { $reason }
drift-over-time = Movement over time
drift-again = Check again
drift-take-back = Undo decision
drift-reason = Reason for keeping the pose
drift-decide = Keep pose
drift-look = frame { $frame }: { $moved_px } px, { $change }
drift-figure = { $untold ->
    [0] { NUMBER($count) } frames compared with the frames of the camera pose. Largest height error: { $worst } (target { $target } high, distance { $distance }). Shaded band: detection limit.
   *[other] { NUMBER($count) } frames compared with the frames of the camera pose, { $untold } not usable. Largest height error: { $worst } (target { $target } high, distance { $distance }). Shaded band: detection limit.
}

## Figures: their downloads and marks

figure-as-svg = { $figure } as SVG
figure-as-csv = { $figure } as CSV
figure-read = Read values: { $figure }
figure-read-hint = Arrow keys move along the axis.
figure-read-value = { $what }: { $value }
figure-no-band = n = { $n }. No band is drawn for fewer than { $least } vehicles: it would cover more than half of the axis.
figure-standard = { $standards } { $height } { $unit }

## Vehicles: budget, history, catalogue, passes

budget-of-click-target = Click on the target
budget-of-click-contact = Click on the tyre contact point
budget-of-clicks = Clicks
budget-of-inset = Inset
budget-of-lens-and-pose = Lens and camera pose
budget-of-board-lean = Board tilt
budget-of-board-roll = Board roll
budget-of-board-height = Board height
budget-of-square-size = Square size of the board
budget-of-board-bow = Board flatness
budget-of-heading = Heading of the vehicle
budget-of-row-time = Row read-out time
budget-of-confirmed-points = Confirmed points
budget-of-drift = Drift of the tracked points
budget-of-baseline = Baseline
budget-of-clock = Clock
budget-of-misalignment = Misalignment of the cameras
budget-of-fit = Fit
budget-of-front = Front
budget-of-rear = Rear
# of earlier versions, both together
budget-of-boundaries = Boundaries
budget-of-front-and-rear = Front and rear
budget-of-regression = Regression
budget-of-following = Tracking
budget-of-frame-times = Frame times
budget-of-depth-of-what-is-followed = Depth of the tracked point
budget-of-seen-from-another-side = Change of viewing angle
budget-of-pose-of-the-line-camera = Pose of the line camera
budget-title = Uncertainty budget
budget-note = standard uncertainty
budget-together = Combined
revisions-computed-again = recomputed; clicked by
revisions-title = History
revisions-who = { $person }, { $time }
revisions-review = { $person } – { $reason }
catalogue-list = { $field } in the catalogue
catalogue-other-years = The catalogue has { $model } only for { $years }. Check the year.
passes-find = Find the passes
passes-find-title = Find the vehicle passes in this video. Existing and discarded passes do not change.
passes-failed = The search for passes failed. Try again.
passes-cancelled = The search for passes in { $recording } was cancelled.
passes-found = { $recording }: { $message }
passes-over = { $recording }: search finished.
passes-show-all = All
passes-show-to_do = To do
passes-show-rejected = Rejected
passes-show-measured = Measured
passes-show-doubtful = Doubtful
passes-show-no_class = No class
passes-doubts = { $count ->
    [one] One height is unusual: check it again.
   *[other] { NUMBER($count) } heights are unusual: check them again.
}
passes-class-missing = The class is missing.
passes-show-left_out = outside the sample
passes-by-number = by number
passes-by-time = by time
passes-by-state = by state

## The picture: frame, loupe, timeline, transport

viewer-frame = frame { $frame }
viewer-frame-label = Frame { $frame }
viewer-frame-at = frame { $frame }, { $time }
viewer-stand-in = thumbnail of frame { $thumbnail }; loading frame { $frame }
viewer-what = frame
viewer-layers = Axes and points over the image
viewer-bright = brightened (display only)
viewer-pointer = x { $x } y { $y }
viewer-wrong-frame = The server sent frame { $served } for frame { $frame }, so it is not shown. Import the recording again.
viewer-slid = Nothing was placed: the pointer moved while the button was down. To move the image, hold Space and drag.
viewer-changed = Nothing was placed: the image changed while the button was down. Click again.
viewer-first-corner = first
timeline-passes = { NUMBER($count) } passes, frames { $first_frame } to { $last_frame }
timeline-label = Position in the recording
timeline-decoded = Decoded on the server
transport-play = Play
transport-stop = Pause
transport-frame = frame
transport-of = of { $last_frame }
transport-vfr-title = Variable frame rate: times come from each frame’s own time stamp
blind-elsewhere = This is not the frame to click on; go to frame { $frame }.
blind-contact = click where the tyre meets the road
blind-target = { $target ->
    [roof] click { target-hint-roof }
    [driver_eye] click { target-hint-driver_eye }
    [taillight] click { target-hint-taillight }
    [headlight] click { target-hint-headlight }
   *[other] click { target-hint-other }
}
blind-wrong-frame = Click on frame { $frame }, where the first clicks are.

## Camera: the page

camera-lead = A camera body and lens at one zoom and focus setting. Calibration determines the lens parameters and their uncertainty.
camera-another = Another camera
camera-loading-all = cameras
camera-loading = the camera
camera-none-title = No camera yet
camera-none = Add the camera that filmed this site. Then add about fifteen images of a checkerboard, taken at the same zoom and focus, or import a calibration file from another tool.
camera-add-first = Add the camera
camera-list = Cameras
camera-take-open = From another survey
camera-take-title = Copy a camera from another survey
camera-take = Copy
camera-take-lead = Copies the current calibration and its images. The two surveys are then independent: a new calibration in one changes no height in the other.
camera-take-survey = Survey
camera-take-camera = Camera
camera-take-none = No camera of this survey has a calibration yet.
camera-take-no-other = There is no other survey yet.
camera-taken-from = copied from { $place }
camera-add = Add a camera
camera-name = Camera { $number }
camera-edit = Change
camera-edit-title = { $camera }
camera-words-none = Lens, zoom and focus are not set.
camera-zoomed = zoom { $zoom }
camera-focused = focus { $focus }
camera-lens-words = Lens
camera-lens-words-hint = As engraved. Example: 24-70 mm f/2.8.
camera-zoom = Zoom
camera-zoom-hint = Example: 28 mm, taped.
camera-focus = Focus
camera-focus-hint = Manual, and the distance. Autofocus changes the lens with every image.
camera-name-problem = Enter a name for the camera.
camera-notes-hint = Body, image size, stabilisation off. If any of these changes, calibrate again.

## Camera: calibrating

camera-calibrate = Calibrate
camera-calibrate-again = Calibrate again
camera-where-boards = Source of the board images
camera-from-images = From images
camera-from-clip = From a recording
camera-choose-pictures = Choose images of the checkerboard
camera-drop-pictures = Drop images of the checkerboard here, or click to choose
camera-drop-hint = Same camera, same zoom and focus. Tilt the board, bring it into every corner, keep it sharp.
camera-found-in = { $count ->
    [one] The board was found in <strong>{ $found }</strong> of { NUMBER($count) } image.
   *[other] The board was found in <strong>{ $found }</strong> of { NUMBER($count) } images.
}
camera-too-few = At least three are needed. Twelve to twenty from different sides give a good calibration.
camera-more-better = Enough to calibrate. Twelve to twenty, with the board tilted and in every corner of the image, give a better result.
camera-other-board = These images were searched for another board. Search again for { $columns } × { $rows } inner corners.
camera-other-board-markers = These images were searched for another board. Search again for { $columns } × { $rows } inner corners and markers of { $dictionary }.
camera-look-again = Search again
camera-to-go = { $count ->
    [one] { NUMBER($count) } image left
   *[other] { NUMBER($count) } images left
}
camera-import = Import a calibration file
camera-import-title = OpenCV YAML or JSON, ROS camera_info, Kalibr, mrcal
camera-imported = { $file } imported.
camera-failed = The calibration failed. Try again.
camera-recording-frames = { $count ->
    [one] { $recording } ({ NUMBER($count) } frame)
   *[other] { $recording } ({ NUMBER($count) } frames)
}
camera-every = Every n-th frame
camera-first-frame = First frame
camera-last-frame = Last frame
camera-no-recording = No recording is ready. <link>Add the clip</link> in which the board is moved.
camera-every-problem = Enter a whole number, 1 or more.
camera-frames-problem = Enter the first and the last frame as whole numbers.
camera-frames-order = The last frame is before the first.
camera-frames-end = The recording ends with frame { $last_frame }.
camera-lens = Lens
camera-lens-brown = Pinhole
camera-lens-fisheye = Fisheye
camera-lens-brown-hint = Pinhole with Brown-Conrady distortion: up to about 100° of view.
camera-lens-fisheye-hint = Equidistant with four terms: for lenses that see more than about 100°.
camera-board = Board
camera-board-flat = Flat board
camera-board-bent = May be bent
camera-board-flat-hint = On a stiff plate. The result states how flat it is.
camera-board-bent-hint = Paper on a wall or thin sheet: the board shape is modelled too. Needs 6 views, better 15.
camera-three-images = Add at least three images that show the board.
camera-corners-found = { $count ->
    [one] { NUMBER($count) } corner found in { $image }
   *[other] { NUMBER($count) } corners found in { $image }
}
camera-remove = Remove { $image }
camera-found-some = { $found } of { $all } found
camera-found-all = { $columns } × { $rows } found

## Camera: the board

camera-inner-corners = Count the <strong>inner corners</strong>: the points where four squares meet. A board of 10 by 7 squares has 9 by 6.
camera-charuco-corners = ChArUco boards are often specified by their squares: subtract one in each direction. Part of the board in an image is enough.
camera-columns = Columns
camera-rows = Rows
camera-square = Square size
camera-square-hint = Measure ten squares with a ruler and divide by ten; printers rarely keep the exact size.
camera-square-problem = { $unit ->
    [ft] Enter the square size in inches, for example { $example }.
   *[m] Enter the square size in millimetres, for example { $example }.
}
camera-count-problem = { $what ->
    [rows] Enter the number of rows as a whole number.
   *[columns] Enter the number of columns as a whole number.
}
camera-count-range = { $what ->
    [rows] Between 3 and 50 rows can be detected; count the inner corners again.
   *[columns] Between 3 and 50 columns can be detected; count the inner corners again.
}
camera-print = Print this board (PDF)
camera-print-hint = True size, on the smallest sheet that fits, with a scale bar to check the print. Glue it to something flat.
camera-drawing = { $kind ->
    [charuco] A ChArUco board, markers in its white squares, with { $columns } inner corners across and { $rows } down: the points where four squares meet. The outer edge does not count.
   *[checkerboard] A board with { $columns } inner corners across and { $rows } down: the points where four squares meet. The outer edge does not count.
}
camera-drawing-columns = { $count ->
    [one] { NUMBER($count) } column
   *[other] { NUMBER($count) } columns
}
camera-drawing-rows = { $count ->
    [one] { NUMBER($count) } row
   *[other] { NUMBER($count) } rows
}
camera-drawing-square = square { $side }

## Camera: a calibration

camera-calibrations = Calibrations
camera-loading-calibration = the calibration
camera-trusted = Calibration reliable
camera-not-trusted = Calibration unreliable
camera-made = { $source ->
    [import] Imported { $time }
    [clip] From a recording { $time }
   *[images] From images { $time }
}
camera-made-by = { $source ->
    [import] Imported { $time }, { $person }
    [clip] From a recording { $time }, { $person }
   *[images] From images { $time }, { $person }
}
camera-use = Use this calibration
camera-residual = RMS reprojection error
camera-not-told = Not stated
camera-download = camera.json
camera-views-used = { $count ->
    [one] { $used } of { NUMBER($count) } view used
   *[other] { $used } of { NUMBER($count) } views used
}
camera-picture = image size
camera-across = { $model ->
    [fisheye] fisheye, about { $angle }° across
   *[brown] pinhole, about { $angle }° across
}
camera-u = u = { $u }
camera-u-note = u is the standard uncertainty (k = 1).
camera-fx = focal length fx
camera-fy = focal length fy
camera-cx = principal point cx
camera-cy = principal point cy
camera-distortion = distortion { $name }
camera-coverage-unknown = The coverage of the image is not known for this calibration.
camera-coverage = Corners cover { $percent } % of the image.
camera-coverage-label = Coverage of the image: { $empty } of { $all } parts contain no corner
camera-coverage-cell = { $count ->
    [one] { NUMBER($count) } corner
   *[other] { NUMBER($count) } corners
}
camera-covered = All parts of the image are covered well enough.
camera-reshoot = Images to add
camera-residuals = Residuals by view
camera-left-out = { $count ->
    [one] { NUMBER($count) } view excluded
   *[other] { NUMBER($count) } views excluded
}
camera-no-reason = no reason stated
camera-residuals-label = Residuals of { $file }, the longest { $longest_px } pixels
camera-worst-view = Worst view.
camera-residuals-drawn = { $file }: residuals enlarged { $times } times; the longest is { $longest_px } px.
camera-history-made = Created
camera-history-by = By
camera-history-from = From
camera-history-verdict = Verdict
camera-history-summary = Summary
camera-history-show = Show
camera-history-shown = shown
camera-show = Show
camera-source-images = images
camera-source-clip = a recording
camera-source-import = a file

## Camera: the checks of a calibration

camera-checks = Checks
camera-halves = Cross-validation (split halves)
camera-halves-not-done = Not done. { $reason }
camera-halves-nothing = The field of view is too small to compare heights.
camera-halves-differ = Heights from the two halves differ by { $differences }.
camera-difference-at = { $difference } at { $distance }
camera-held-out = RMS reprojection error, held-out images: { $held_out }; fitted images: { $fit }.
camera-under = under { $length }
camera-vehicle-at = Vehicle at
camera-heights-differ = Height difference
camera-expected = Expected u (k = 1)
camera-not-in-picture = not in the image
camera-halves-note = Height of an eye at { $eye } computed with each half (camera level at { $camera }, board at { $board }, the same clicks). “Expected” is the difference from corner noise alone.
camera-flatness = Flatness deviation of the board
camera-board-solved = Board shape modelled: it bends by { $bow }. RMS reprojection error { $flat } as flat, { $bent } with the shape modelled.
camera-board-taken-flat = Taken as flat. The images indicate a bend of { $bow }. RMS reprojection error { $flat } as flat, { $bent } with the shape modelled.

## Camera pose: the page

pose-loading = the camera pose
pose-no-recording-title = No recording with the board yet
pose-no-recording = Add the video in which the checkerboard stands on the road; the camera pose is computed from it.
pose-add-recordings = Add recordings
pose-mark-first = Mark the first frame of the board
pose-mark-last = Mark the last frame of the board
pose-side = Board and result
pose-board-span = Board: frames { $first_frame } to { $last_frame }
pose-go-again = This recording has a camera pose. To compute it again, go to a frame with the board at rest.
pose-go = Go to a frame with the board at rest.
pose-looking = Searching for the board…
pose-found-part = Part found
pose-found = { $columns } × { $rows } found
pose-chosen = This pose is now current for the recording; new measurements use it.

## Camera pose: the questions

pose-lens = Recording and lens
pose-calibration-none = none yet
pose-calibration = { $state ->
    [current] { $camera }, { $calibration }, current
    [current_not_trusted] { $camera }, { $calibration }, current, unreliable
    [not_trusted] { $camera }, { $calibration }, unreliable
   *[other] { $camera }, { $calibration }
}
pose-board = The board
pose-columns = Inner corners across
pose-rows = and down
pose-square = Square
pose-corners-hint = Inner corners are where four squares meet: a board of 10 by 7 squares has 9 by 6.
pose-charuco-hint = A camera pose needs the whole board in sight.
pose-still = Stationary frames
pose-begins = Set first
pose-begins-title = The first frame
pose-ends = Set last
pose-ends-title = The last frame
pose-span-offer = The board is stationary from frame { $first_frame } to { $last_frame }.
pose-span-take = Use these frames
pose-not-marked = not marked yet
pose-end-not-marked = from { $first_frame }, end not marked
pose-marked = { $count ->
    [one] { $first_frame } to { $last_frame }, { NUMBER($count) } frame
   *[other] { $first_frame } to { $last_frame }, { NUMBER($count) } frames
}
pose-height = Board height
pose-reference = Reference row
pose-reference-bottom = lowest row of corners
pose-reference-top = uppermost row
pose-reference-height = { $reference ->
    [top] From the road up to the uppermost row of inner corners
   *[bottom] From the road up to the lowest row of inner corners
}
pose-reference-height-hint = Measure it for each recording; it is never copied from another.
pose-drawing = { $reference ->
    [top] The tape runs from the road up to the uppermost row of inner corners.
   *[bottom] The tape runs from the road up to the lowest row of inner corners.
}
pose-drawing-tape = tape
pose-drawing-road = road
pose-sure = Standard uncertainties
pose-u-tape = u(height)
pose-u-lean = u(tilt and roll)
pose-u-square = u(square size)
pose-u-bow = u(flatness)
pose-u-hint = Defaults are Type B estimates: steel tape on asphalt 3 mm; spirit level 0.3° (tilt and roll alike); printed square 0.1 %; flatness of a stiff board 0.5 mm. Each is a separate line in the uncertainty budget.
pose-find = Compute the camera pose
pose-find-again = Compute the camera pose again
pose-stopped = Stopped; nothing was changed.
pose-look-only = View only. An operator computes the pose.
pose-problem-calibration = Calibrate the camera first. The pose needs the lens parameters.
pose-problem-board = A board needs at least 2 by 2 inner corners.
pose-problem-square = Enter the side of one square. Measure across several squares and divide.
pose-problem-height = Enter the height measured with a tape.
pose-problem-u = Each must be a number of 0 or more.
pose-problem-span = Mark the frames with the board at rest.

## Camera pose: the result

pose-result = Camera pose of the recording
pose-download = pose.json
pose-result-earlier = Earlier camera pose
pose-use = Use this pose for the recording
pose-measure = Start measuring
pose-expected = Expected uncertainty of a height
pose-expected-distance = Distance
pose-expected-good = Height U95
pose-expected-U95 = ± { $U95 }
pose-expected-reason = No U95 at { $distance }. { $reason }
pose-facts = Frames { $first_frame } to { $last_frame }; residual of the corners { $fit }; board at { $distance }.
pose-other-recording = another recording
pose-poses = { $count ->
    [one] { NUMBER($count) } pose in this survey
   *[other] { NUMBER($count) } poses in this survey
}
pose-made = { $time }, frames { $first_frame } to { $last_frame }
pose-use-short = Use

## Recordings

recordings-lead = Frame numbers are the same for everyone. Line-scan strips are added under Line scans.
recordings-loading = recordings
recordings-choose = Choose videos to upload
recordings-drop = Drop videos here, or click to choose
recordings-drop-hint = Interrupted uploads resume where they stopped, even after you close this page.
recordings-uploads = Uploads
recordings-none-title = No recordings yet
recordings-none = Add the video of the day: MP4, MOV, AVI, MKV and others. Add the clip with the checkerboard on the road too: the camera pose is computed from it.
recordings-none-look = An operator can upload the day’s video here.
recordings-delete-title = Delete { $recording }?
recordings-delete-body = This deletes the video, its frame table and its passes. A recording with measurements cannot be deleted.
recordings-delete = Delete the recording
recordings-delete-one = Delete { $recording }
recordings-download-one = Download the video of { $recording }
recordings-deleted = { $recording } was deleted.
recordings-vfr-title = Variable frame rate: times come from each frame’s own time stamp
recordings-picture-read = Video track { $number } of { NUMBER($count) } in the file
recordings-picture-read-too = Import video track { $number } too ({ $codec }, { $size })
recordings-picture-read-of = Import video track { $number } of { $recording } as a separate recording
recordings-picture-added = { $name } is being imported.
recordings-filming-rate-unknown = Filming rate not confirmed; motion is not measured.
recordings-filming-rate-is = Filmed at { $rate } frames/s, as entered
recordings-filming-rate-state = Enter the filming rate
recordings-filming-rate-of = Enter the filming rate of { $recording }
recordings-filming-rate-title = Filming rate of { $recording }
recordings-filming-rate = Filming rate
recordings-filming-rate-unit = frames/s
recordings-filming-rate-hint = From the camera’s settings or manual. The video is imported again with these times; existing heights do not change.
recordings-filming-rate-bounds = Enter a number from 1 to 2000.
recordings-filming-rate-action = Import with this rate
recordings-find-road = Compute camera pose
recordings-measure = Measure
recordings-read-again = Import again
recordings-unreadable = This recording could not be imported.
recordings-no-picture = no image
recordings-no-picture-yet = no image yet
recordings-rename = Rename
recordings-rename-one = Rename { $recording }
recordings-name = Name of the recording
recordings-frames = { $count ->
    [one] { NUMBER($count) } frame
   *[other] { NUMBER($count) } frames
}
recordings-rate = { $rate } frames/s
recordings-rate-average = { $rate } frames/s on average
recordings-codec = { $codec } in { $container }
recordings-passes = { $count ->
    [0] no passes yet
    [one] { NUMBER($count) } pass
   *[other] { NUMBER($count) } passes
}
recordings-sha256 = SHA-256 { $sha256 }
recordings-no-camera = No camera yet: <link>calibrate one</link>.
recordings-camera = Camera
recordings-camera-unsaid = Not set
recordings-camera-uncalibrated = { $camera } (not calibrated)
recordings-lighting = Lighting
recordings-lighting-proposed = Lighting <muted>(suggested)</muted>
recordings-lighting-of = Lighting of { $recording }
recordings-lighting-of-proposed = Lighting of { $recording }, suggested by Sightline
recordings-lighting-guess = { $lighting } (suggested)

filmed-start = Filmed from { $time } ({ $zone })
filmed-at = filmed { $time }
filmed-proposed = Start not confirmed; suggested by the file: { $time } ({ $zone })
filmed-unknown = Start not known: the file contains no time.
filmed-edit = Change
filmed-edit-of = Change the start and weather of { $recording }
filmed-confirm = Confirm the start
filmed-enter = Enter the start
filmed-confirm-of = Confirm the start of { $recording }
filmed-enter-of = Enter the start of { $recording }
filmed-confirm-action = Confirm
filmed-title = Start and weather of { $recording }
filmed-started = First frame, local time
filmed-unsay = Not known
filmed-from-file = Suggested by the file: { $time }. Camera clocks are often wrong by minutes, or by the summer-time hour: compare with a watch in the video or with your notes.
filmed-from-file-none = The file contains no time: take it from a watch in the video or from your notes.
filmed-zone = Time zone
filmed-which = This hour occurs twice
filmed-first = the first time ({ $offset })
filmed-second = the second time ({ $offset })
filmed-weather = Weather
filmed-weathers = clear, some cloud, overcast, fog, light rain, rain, snow
filmed-lamps = Street lighting
filmed-lamps-on = on
filmed-lamps-off = off
filmed-lamps-are = { $state ->
    [on] street lighting on
   *[off] street lighting off
}
filmed-not-said = Not set

## Uploads

upload-state = { $state ->
    [waiting] { $file }: starting
    [paused] { $file }: paused
    [retrying] { $file }: connection lost, trying again
    [failed] { $file }: stopped
    [read] { $file }: uploaded, importing
    [kept] { $file }: uploaded
   *[sending] { $file }: uploading
}
upload-resumed = { $file }: sending, resumed at { $arrived }
upload-amount = { $arrived } of { $size }
upload-rate = { $arrived } of { $size } · { $speed }/s · { $time } left
upload-pause = Pause
upload-resume = Resume
upload-cancel = Cancel the upload of { $file }
upload-empty = { $file } is empty; check the copy and choose the file again.
upload-not-loaded = The page could not be loaded completely. Reload it and choose the file again.
upload-broken = The connection was lost while { $file } was being sent. What arrived is kept: press “Resume” when you are online again.
upload-unfinished = { $file }: not finished; drop the same file again to continue
upload-discard-title = Delete the partial upload?
upload-discard-body = { $arrived } of { $file } are on the server.
upload-discard = Delete
upload-discard-one = Delete the partial upload of { $file }

## Words that many pages need

interval = { $low } to { $high }
words-apart = { $first }; { $second }
person-system = Sightline
person-unknown = unknown
menu-language = Language
stage-frame = Frame
stage-frames = Frames
stage-timeline = Timeline
stage-fit = Fit
stage-lines = Lines
stage-bright = Bright
stage-loupe = Magnifier
vfr = VFR
field-name = Name
field-recording = Recording
field-calibration = Calibration
in-use = current
field-notes = Notes
action-add = Add
action-cancel = Cancel
action-close = Close
dialog-discard-title = Discard what you entered?
dialog-discard-body = It has not been saved.
dialog-discard = Discard
action-dismiss = Dismiss
action-save = Save
action-try-again = Try again
action-clear-filter = Clear filters
action-print = Print
file-csv = CSV
figure-share-of-vehicles = Share of vehicles (%)
with-unit = { $name } ({ $unit })
percent = { $percent } %
with-u = { $value } (u = { $u })
value-px = { $value } px
value-s = { $value } s
file-svg = SVG
unit-px = px
unit-byte = B
unit-hz = Hz
unit-ppm = ppm
unit-mrad = mrad

## Checks: the page

adjust-lead = Compare the camera pose with vehicles of known wheelbase and height. Nothing changes until you apply the adjusted pose; heights are then computed again, and both can be undone together.
adjust-tab = Adjustment
adjust-loading = the adjustment
adjust-no-pose = No recording has a camera pose yet.
adjust-pose = Camera pose { $pose }: { $recordings }
adjust-seen = Vehicles with both tyres and a known wheelbase: { $tyres }. With a measured roof and a known height: { $roofs }.
adjust-u-wheelbase = Default u of a wheelbase ({ $unit })
adjust-u-wheelbase-common = u common to all wheelbases ({ $unit })
adjust-u-roof-common = u common to all roofs ({ $unit })
adjust-u-problem = Enter a length from 0 to 1 m, for example { $example }.
adjust-used = { $used } of { $passes } observations used.
adjust-global-holds = Global test passed: chi-square { $chi2 } with { $freedom ->
    [one] 1 degree
   *[other] { NUMBER($freedom) } degrees
 } of freedom is below { $limit }.
adjust-global-fails = Global test failed: chi-square { $chi2 } with { $freedom ->
    [one] 1 degree
   *[other] { NUMBER($freedom) } degrees
 } of freedom is above { $limit }. The stated uncertainties are not consistent.
adjust-largest = Largest change of a stored height: { $largest }.
adjust-adjusted = This pose was adjusted to the traffic. The previous pose is number { $pose }.
adjust-put = Apply
adjust-put-done = The adjusted pose is current.
adjust-take-back = Undo
adjust-taken-back = The previous pose is current again.
adjust-moved-title = Parameter changes
adjust-what = Parameter
adjust-value = Change
adjust-by-u = Change / u
adjust-by-u-help = Change divided by the standard uncertainty before
adjust-u-before = u before
adjust-u-after = u after
adjust-moved-camera_height_m = camera height above the road
adjust-moved-road_lean_rad = rotation of the road about its length (tilt)
adjust-moved-road_roll_rad = rotation of the road about the direction across it (roll)
adjust-moved-board_lean_rad = board tilt
adjust-moved-board_roll_rad = board roll
adjust-moved-board_height_m = height of the board’s reference row
adjust-moved-square_m = square size of the board
adjust-moved-bow_along_rows_m = board bow along its rows
adjust-moved-bow_down_columns_m = board bow along its columns
adjust-moved-wheelbase_common_m = error common to all wheelbases
adjust-moved-roof_common_m = error common to all roofs
adjust-moved-roof_inset_common_m = error common to all roofs of one assumed inset
adjust-common-of = { $what } ({ $length })
adjust-left-title = Not used
adjust-left-none = All observations are used.
adjust-of-tyres = tyres
adjust-of-roof = roof
adjust-models-title = Leave one model out
adjust-models-note = Change of the camera height when all vehicles of one model are left out. A model that dominates the result stands out here.
adjust-model = Model
adjust-vehicles = Vehicles
adjust-camera = Camera height
adjust-heights-title = Effect on each height
adjust-now = Now
adjust-then = Adjusted
computing-lead = Heights depend on the camera pose (for line scans: the rod calibration), the inset, the driver’s side and the version of Sightline. When one of these changes, stored heights stay unchanged until they are computed again here: as new revisions, compared with the old ones, which can be undone together.
computing-loading = out-of-date heights
computing-fine = All heights are up to date.
computing-stale = { $count ->
    [one] One height is out of date: { $causes }.
   *[other] { NUMBER($count) } heights are out of date: { $causes }.
}
computing-in-line-scans = { $count ->
    [one] One of them is in a line scan.
   *[other] { NUMBER($count) } of them are in line scans.
}
computing-waiting = { $count ->
    [one] One of them has no height yet and will get one.
   *[other] { NUMBER($count) } of them have no height yet and will get one.
}
computing-other-program = { $count ->
    [one] One height was computed by another version of Sightline. Computing it again may give the same value.
   *[other] { NUMBER($count) } heights were computed by another version of Sightline. Computing them again may give the same values.
}
computing-cause-pose = { NUMBER($count) } with another camera pose or calibration
computing-cause-inset = { NUMBER($count) } with another inset
computing-cause-side = { NUMBER($count) } with another driver’s side
computing-cause-program = { NUMBER($count) } by another version of Sightline
computing-start = Compute again
computing-look = Review and compute again
computing-which = Which heights
computing-mark-pose = Out of date: the camera pose has changed since.
computing-mark-inset = Out of date: the inset has changed since.
computing-mark-side = Out of date: the driver’s side has changed since.
computing-mark-program = Out of date: another version of Sightline computed it.
computing-nothing-changed = No height changed, so nothing was saved.
computing-done = { $count ->
    [one] One height computed again.
   *[other] { NUMBER($count) } heights computed again.
}
computing-runs = Previous runs
computing-runs-none = No heights have been computed again in this survey.
computing-when = When
computing-who = By
computing-kind = Reason
computing-kind-asked = requested
computing-kind-sides = driver’s side set
computing-kind-adjustment = adjusted pose applied
computing-kind-undo = undo
computing-heights = Heights
computing-to-review = To review
computing-largest = Largest change
computing-undone = undone
computing-show = Show
computing-shown = shown
computing-old-new = Old and new values
computing-summary = { $count ->
    [one] { NUMBER($count) } height: { $causes }; mean change { $mean }, largest { $largest }.
   *[other] { NUMBER($count) } heights: { $causes }; mean change { $mean }, largest { $largest }.
}
computing-summary-undo = { $count ->
    [one] One height was restored to its previous value.
   *[other] { NUMBER($count) } heights were restored to their previous values.
}
computing-kept = { $count ->
    [one] One was changed since and stays unchanged.
   *[other] { NUMBER($count) } were changed since and stay unchanged.
}
computing-sent = { $count ->
    [0] No height changed by more than its standard uncertainty, so all verdicts remain valid.
    [one] One height changed by more than its standard uncertainty and returns to review; the other verdicts remain valid.
   *[other] { NUMBER($count) } heights changed by more than their standard uncertainty and return to review; the other verdicts remain valid.
}
computing-undo = Undo all
computing-undo-text = Restores every height of this run to its previous value, as a new revision. Heights changed since then stay unchanged.
computing-figure = Change of each height
computing-figure-says = The change of { NUMBER($count) } heights against their distance across the road, in { $small }.
computing-figure-lines = Change of each height in line scans
computing-figure-says-lines = The change of { NUMBER($count) } heights in line scans against the distance of their contact from the camera, in { $small }.
computing-figure-x-lines = contact from the camera ({ $unit })
computing-line-scan = line scan
computing-figure-x = contact across the road ({ $unit })
computing-figure-y = new − old ({ $small })
computing-figure-note = Filled: changed by more than the standard uncertainty it had. A change that grows with distance comes from the camera pose; a change common to one target comes from its inset.
computing-figure-none = No height exists both before and after.
computing-vehicle = Vehicle
computing-target = Target
computing-before = Old
computing-after = New
computing-change = Change
computing-by-u = Change / u
computing-by-u-help = Change divided by the previous standard uncertainty
computing-review-yes = to review
computing-repeat = repeat
computing-listed = The { NUMBER($count) } largest changes relative to u are listed; the package contains all.
computing-table = Old and new heights
computing-job = the job
checks-again = Compute again
checks-lead = Compare insets and road axes with the measured vehicles.
checks-loading = the checks
checks-insets = Insets
checks-direction = Direction
checks-eye = Driver’s eye

## Checks: insets

checks-insets-title = Insets: current and estimated from this survey
checks-insets-loading = the estimates
checks-insets-table = Current insets
checks-target = Target
checks-in-force = Current
checks-from = Source
checks-inset-and-u = Inset, u of the mean
checks-moves = Change in height
checks-insets-note = A new inset applies to new measurements only; existing measurements keep theirs until they are computed again. Its u applies to a single vehicle: it combines the uncertainty of the mean and the spread between vehicles.
checks-by-known_heights = manufacturers’ heights
checks-by-trend = trend with distance
checks-by-two_frames = two-frame measurements
checks-measurements = { $count ->
    [one] { NUMBER($count) } measurement
   *[other] { NUMBER($count) } measurements
}
checks-other-insets = { NUMBER($count) } with a different inset, not used
checks-estimate = estimate
checks-vehicles = { $count ->
    [one] { NUMBER($count) } vehicle
   *[other] { NUMBER($count) } vehicles
}
checks-vehicles-without = { $count ->
    [one] { NUMBER($count) } vehicle
   *[other] { NUMBER($count) } vehicles
} <without>without { $left_out }</without>
checks-left-out-help = Outliers: check their clicks and heights.
checks-spread = { $spread } between vehicles
checks-use = { $target ->
    [roof] Use { $inset } (u = { $u_inset }) for roofs of cars
    [roof_van] Use { $inset } (u = { $u_inset }) for roofs of vans
    [roof_box] Use { $inset } (u = { $u_inset }) for roofs of lorries and buses
    [roof_unknown] Use { $inset } (u = { $u_inset }) for roofs without a class
    [driver_eye_near] Use { $inset } (u = { $u_inset }) for near drivers’ eyes
    [driver_eye_far] Use { $inset } (u = { $u_inset }) for far drivers’ eyes
    [taillight] Use { $inset } (u = { $u_inset }) for taillights
    [headlight] Use { $inset } (u = { $u_inset }) for headlights
   *[other] Use { $inset } (u = { $u_inset }) for other targets
}
checks-used = { $target ->
    [roof] New measurements of car roofs use the new inset; existing ones keep theirs.
    [roof_van] New measurements of van roofs use the new inset; existing ones keep theirs.
    [roof_box] New measurements of the roofs of lorries and buses use the new inset; existing ones keep theirs.
    [roof_unknown] New measurements of roofs without a class use the new inset; existing ones keep theirs.
    [driver_eye_near] New measurements of near drivers’ eyes use the new inset; existing ones keep theirs.
    [driver_eye_far] New measurements of far drivers’ eyes use the new inset; existing ones keep theirs.
    [taillight] New measurements of taillights use the new inset; existing ones keep theirs.
    [headlight] New measurements of headlights use the new inset; existing ones keep theirs.
   *[other] New measurements of other targets use the new inset; existing ones keep theirs.
}

## Checks: what the inset is

checks-inset-what = What the inset is
checks-inset-title = What the inset is, and why it matters
checks-inset-plane = A height is computed where the line of sight meets the <strong>side plane</strong>: the vertical plane through the tyre contact point, parallel to the traffic. A roof edge or a driver’s eye lies behind this plane, at a distance called its <strong>inset</strong>. Without a correction, a target below the camera reads too high, and one above it too low.
checks-inset-formula = read − true = (H<sub>c</sub> − h) · inset / (D + inset)
checks-inset-symbols = H<sub>c</sub> is the camera’s height, h the target’s, D the distance from the camera to the side plane. If camera and target have the same height, the inset has no effect. Every stored height is corrected for it; the uncorrected height is stored too.
checks-missing-inset = Error without inset correction
checks-missing-inset-caption = Height error without inset correction, for the camera at { $camera_height }
checks-height = Height
checks-inset = Inset
checks-at = At { $distance }
checks-drawing = Cross-section of the road. The camera looks down at a target behind the side plane through the tyre; its ray meets the plane above the target.
checks-drawing-camera = camera
checks-drawing-side-plane = side plane
checks-drawing-inset = inset
checks-drawing-read = read here
checks-drawing-target = the target
checks-drawing-too-high =
    too
    high

## Checks: the travel direction

checks-vehicles-loading = the vehicles
checks-no-vehicles-title = No vehicles yet
checks-no-vehicles = The travel direction is computed from the tyres of vehicles. Mark their passes first.
checks-mark-passes = Mark the passes
checks-withdraw = Withdraw the tyres
checks-previous = Previous
checks-next = Next
checks-no-pose = This recording has no camera pose yet.
checks-no-pose-link = Measuring needs the camera pose of this recording; <link>compute it</link> first.
checks-turned-road = Preview of the rotated pose.
checks-replace = Click again to replace it.
checks-choose-vehicle = Choose a vehicle.
checks-first-tyre = Click the contact point of the first near-side tyre.
checks-second-tyre = Click the contact point of the other tyre on the same side.
checks-verdict = Verdict
checks-mean = Mean
checks-spread-of-vehicles = Between vehicles
checks-used-vehicles = Used
checks-used-of = { $count ->
    [one] { NUMBER($count) } vehicle of { NUMBER($all) }
   *[other] { NUMBER($count) } vehicles of { NUMBER($all) }
}
checks-turned-from = This pose was rotated by { $turned } from pose { $pose }.
value-u = { $value } (u = { $u })
checks-turn-by = Rotate the road axes by { $turn }…
checks-use-before = Use the previous pose
checks-turned-pose = Rotated pose
checks-turned-by = Rotated by { $turn }
checks-turn-no-heights = No stored height uses this pose.
checks-turn-heights = { $count ->
    [one] { NUMBER($count) } stored height would differ by up to { $largest } if clicked again. Stored values do not change.
   *[other] { NUMBER($count) } stored heights would differ by up to { $largest } if clicked again. Stored values do not change.
}
checks-differences = Height differences
checks-vehicle = Vehicle
checks-turned = Rotated
checks-turn = Rotate
checks-turn-done = Rotated pose applied to new measurements. Existing measurements are unchanged.
checks-turn-back-done = The previous pose is current again.
checks-heading = Heading
checks-apart = Between tyres
checks-two-frames = from two frames
checks-tyres = tyres of vehicle { $vehicle }
checks-withdrawal = withdrawal of the tyres of vehicle { $vehicle }
checks-tyres-none = none
checks-tyres-at = frame { $frame }, at { $first } and { $second } px

## Measure: the page

measure-loading = the frame
measure-none-title = No recording to measure yet
measure-none = Heights are measured on the frames of a recording. Add the day’s videos first; you can measure as soon as they are imported.
measure-add-recordings = Add recordings
measure-last-pass = This is the last pass in the list.
measure-first-pass = This is the first pass in the list.
measure-all-passes-done = Every pass of this survey is measured.
measure-other-tab = Also open in another tab. If both change it, you choose which to keep.

## Measure: the passes

measure-passes = Passes
measure-passes-open = Passes <muted>{ NUMBER($count) } to do{ $rejected ->
    [0] {""}
   *[other] , { NUMBER($rejected) } rejected
}</muted>
measure-passes-show = Show
measure-passes-order = Order
measure-passes-none = No passes yet. Find the passes, or mark the first frame of a vehicle.
measure-passes-none-in-state = No pass is in this state.
measure-class-missing = Missing: the inset of the roof and the figures of each class depend on it.
measure-proposals-late = Show the suggestions
measure-proposals-late-title = They arrived after you started, so your keys and clicks kept their meaning.
measure-progress = { NUMBER($count) } of { NUMBER($all) }
measure-pass-begins = Pass begins on this frame
measure-pass-begin = Add pass here
measure-pass-ends = Pass ends on this frame
measure-pass-end = …ends here
measure-pass-drop = Cancel the new pass
measure-pass-frames = { $count ->
    [one] { NUMBER($count) } frame
   *[other] { NUMBER($count) } frames
}
measure-pass-marked = The pass begins at frame { $frame }. Go to its last frame and mark it.
measure-pass-new = New pass
measure-pass-new-short = new
measure-pass-found = found
measure-pass-title = Pass { $vehicle }: frames { $first_frame } to { $last_frame }
measure-pass-title-more = Pass { $vehicle }: frames { $first_frame } to { $last_frame }, { $more }
measure-way-right = to the right
measure-way-left = to the left
measure-unconfirmed = found by Sightline, not yet confirmed
measure-unconfirmed-way = { $way ->
    [right] to the right, found by Sightline, not yet confirmed
   *[left] to the left, found by Sightline, not yet confirmed
}
measure-pass-menu = Vehicle { $vehicle }: split, join, discard
measure-pass-confirm = { $lighting ->
    [daytime] Confirm: daytime
   *[low_light] Confirm: low light
}
measure-pass-split = Split before this frame
measure-pass-join = Join with the next pass
measure-pass-splitted = Vehicle { $vehicle } was split at frame { $frame }; the other part is vehicle { $other }.
measure-pass-joined = Vehicle { $gone } was joined to vehicle { $kept }.
measure-pass-no-next = No pass of this recording begins after this one, so there is nothing to join.
measure-pass-delete-of = Delete the pass of vehicle { $vehicle }
measure-pass-delete-title = Delete vehicle { $vehicle }?
measure-pass-delete-body = { $count ->
    [0] Vehicle { $vehicle } will be deleted. You can undo this.
    [one] Vehicle { $vehicle } and its { NUMBER($count) } measurement will be deleted. You can undo this.
   *[other] Vehicle { $vehicle } and its { NUMBER($count) } measurements will be deleted. You can undo this.
}
measure-pass-delete = Delete the pass
measure-pass-bring-back = Bring the pass back
measure-pass-kept = Kept in this browser; it will be sent when the connection is back.
measure-pass-new-frames = frames { $first_frame } to { $last_frame }

## Measure: what undo and redo name

measure-step-of = { $step }, vehicle { $vehicle }
measure-step-vehicle = facts of vehicle { $vehicle }
measure-step-new-pass = new pass { $vehicle }
measure-step-deletion = deletion of vehicle { $vehicle }
measure-step-split = split of vehicle { $vehicle }
measure-step-joining = joining of vehicles { $vehicle } and { $next }
measure-step-contact = contact point
measure-step-snap = snap to the tyre
measure-snapped = snapped to the tyre, u = { $expected_px } px; { $key }: back to your click
measure-step-proposals = confirmed suggestions
measure-step-contact-removal = removal of the contact
measure-step-move = move of a point
measure-step-inset = inset
measure-step-new = { $target ->
    [roof] new roof
    [driver_eye] new driver’s eye
    [taillight] new taillight
    [headlight] new headlight
   *[other] new other target
}
measure-step-withdrawal = { $target ->
    [roof] withdrawal of the roof
    [driver_eye] withdrawal of the driver’s eye
    [taillight] withdrawal of the taillight
    [headlight] withdrawal of the headlight
   *[other] withdrawal of the other target
}
measure-step-frame = { $nth ->
    [2] second frame
    [3] third frame
    [4] fourth frame
    [5] fifth frame
    [6] sixth frame
    [7] seventh frame
    [8] eighth frame
   *[other] further frame
}
measure-step-frame-removal = removal of frame { $frame }

## Measure: the frame

viewer-place-here = Place it here
measure-driver = { $side ->
    [near] driver near
    [far] driver far
   *[unknown] driver’s side unknown
}
measure-find-pose = Compute the camera pose
measure-no-pose = No camera pose. Compute it before you measure.
measure-choose-pass = Choose a pass on the left, or mark a new one with [ and ].
measure-look-only = View only. Ask an administrator for the operator role.
measure-vehicle-done = Done. Keys 1 to 5 measure again.
measure-next-pass = Next pass
measure-choose-target = Choose a target: 1 to 5.
measure-drift = Camera moved { $moved_px } px after the pose was computed. <link>Compute a new pose or decide</link>
measure-drift-off = Camera moved { $moved_px } px after the pose was computed. Height error: up to { $off } at { $distance }, different at other distances. <link>Compute a new pose or decide</link>
measure-proposal-looking = Searching for the wheel…
measure-proposal-take = { $proposal }. Press Enter or click it to accept.
measure-proposal-no-pass = Choose a pass first. Then a contact can be suggested.
measure-axes-awaited = loading axes…
measure-proposal-no-contact = Start a new contact point first.
measure-proposal-no-pointer = Point at where the tyre meets the road, then ask for a suggestion.

## Measure: what Sightline proposes to click

measure-propose = Suggest points
measure-propose-title = Suggests points on every found pass of this recording. Earlier suggestions are replaced; nothing is measured.
measure-propose-failed = The suggestions failed. Try again.
measure-propose-cancelled = Suggesting points in { $recording } was cancelled; earlier suggestions are kept.
measure-propose-over = { $recording }: the suggestions are ready.
measure-proposed = Suggested, not measured: Enter confirms, a point’s key goes to it.
measure-proposed-awaited = Suggested, not measured: computing the heights…
measure-proposed-selected = Drag the point or use the arrow keys. Enter confirms all; pressing its key again rejects it.
measure-proposed-mark = { $what }, suggested
measure-proposed-title = Suggestions
measure-proposed-contact = Contact
measure-proposed-accept = { $count ->
    [0] Confirm the contact
    [one] Confirm 1 target
   *[other] Confirm { NUMBER($count) } targets
}
measure-proposed-accept-title = Saves the suggested points as measurements, in your name
measure-proposed-on-frame = Suggestions on frame { $frame }
measure-proposed-go = Go to this point, to check and move it
measure-proposed-expected = u = { $expected_px } px
measure-proposed-expected-title = Expected standard uncertainty of this point
measure-proposed-doubt = Vehicle { $vehicle }: a height that you confirmed is unusual. Check it again.
measure-proposed-moved = moved by you
measure-points-set = Points
measure-made = { $made ->
    [snapped] Contact snapped to the tyre, target by hand
    [confirmed] Suggested by Sightline, confirmed
    [moved] Suggested by Sightline, moved by hand
   *[clicked] Clicked by hand
}

## Measure: the measurements of a vehicle

measure-measurements = Measurements
measure-target = Measure: { $target }
measure-target-afresh = Measure again: { $target }
measure-targets-idle = Not asked for in this survey
measure-afresh = { $target ->
    [roof] Roof measured again. The previous value is in the history.
    [driver_eye] Driver’s eye measured again. The previous value is in the history.
    [taillight] Taillight measured again. The previous value is in the history.
    [headlight] Headlight measured again. The previous value is in the history.
   *[other] Other target measured again. The previous value is in the history.
}
measure-show-point = Show and select the point
measure-click = click on the frame
measure-details-show = { $target ->
    [roof] Show the details of the roof
    [driver_eye] Show the details of the driver’s eye
    [taillight] Show the details of the taillight
    [headlight] Show the details of the headlight
   *[other] Show the details of the other target
}
measure-details-hide = { $target ->
    [roof] Hide the details of the roof
    [driver_eye] Hide the details of the driver’s eye
    [taillight] Hide the details of the taillight
    [headlight] Hide the details of the headlight
   *[other] Hide the details of the other target
}
measure-discard = Discard
measure-doubt = { $kind ->
    [above_roof] This is above the roof ({ $low }). Check that the point is on the right feature.
    [below_lamp] The headlight is higher ({ $low }). Check that the point is on the driver’s eye.
    [far_from_maker] The manufacturer’s height is { $low }. Check the points, and make and model.
   *[outside_class] Vehicles of this class are between { $low } and { $high }. Check the points and the category.
}
measure-not-yet-saved = not yet saved…
measure-not-stored = not saved
measure-click-again = Click it again.
measure-click-again-key = Click it again ({ $key }).
measure-no-way-back = This could not be undone.
measure-clicked-on = clicked on frame { $frame }
measure-contact = Contact
measure-point = Target
measure-distance = Distance
measure-lateral = Tyre position across the road, from the board
measure-along = Tyre position along the road, from the board
measure-without-inset = Uncorrected height (inset = 0)
measure-withdraw = Withdraw
measure-px = { $across_px }, { $down_px } px
measure-inset = Inset
measure-inset-u = u
measure-estimate = estimate
measure-inset-solved = Not used: solved from several frames
measure-inset-what = lateral distance from the side plane of the vehicle to the target
measure-inset-as-survey = Reset to survey value ({ $inset }, u = { $u_inset })
measure-inset-side = Driver’s side
measure-unseen = Not visible: { $why }.
measure-unseen-back = Mark as visible
measure-unseen-ask = Not visible…
measure-unseen-why = { $target ->
    [roof] Why is the roof not visible?
    [driver_eye] Why is the driver’s eye not visible?
    [taillight] Why is the taillight not visible?
    [headlight] Why is the headlight not visible?
   *[other] Why is it not visible?
}
measure-side-unknown = not known
measure-side-as-survey = survey default
measure-side-from = { $from ->
    [said] set for this vehicle
    [direction] { $direction ->
        [right] travels to the right
       *[left] travels to the left
    }, steering wheel on the { $steering ->
        [right] right
       *[left] left
    }
    [place] direction unknown: seen from the median, all traffic runs one way
    [undirected] direction unknown, so the eye height cannot be computed: set near or far here, or the direction of the vehicle
   *[unknown] unknown, so the eye height cannot be computed: set it here for this vehicle, or under <link>Settings</link> for all
}
measure-inset-roof = Roof point
measure-inset-needs-class = Choose the class: the inset of a roof depends on it.
measure-inset-now = inset { $inset } (u = { $u_inset }), estimate

## Measure: several frames

measure-second-looking = Searching for the best second frame…
measure-second-hint = { $nth ->
    [2] Second frame
    [3] Third frame
    [4] Fourth frame
    [5] Fifth frame
    [6] Sixth frame
    [7] Seventh frame
    [8] Eighth frame
   *[other] Further frame
}: { $what ->
    [elsewhere] go to another frame of the pass
    [contact] click the same tyre contact
    [roof] click the same roof point
    [driver_eye] click the same driver’s eye point; if it is hidden, go to another frame
    [taillight] click the same taillight point
    [headlight] click the same headlight point
   *[other] click the same point of the other target
}
measure-second-hint-care = { $hint }. { $care }
measure-second-nothing-yet = Measure a target first. Then you can add a second frame.
measure-second-no-use = A second frame does not help.
measure-second-none = { $target }: { $reason }
measure-second-clicked-already = You have already used this frame. Choose another.
measure-second-expected = Expected here
measure-second-expected-at = at { $speed }
measure-frames-said = { $count ->
    [one] From { NUMBER($count) } frame
   *[other] From { NUMBER($count) } frames
}
measure-frames-said-inset = { $count ->
    [one] From { NUMBER($count) } frame; inset { $inset } (u = { $u_inset })
   *[other] From { NUMBER($count) } frames; inset { $inset } (u = { $u_inset })
}
measure-whole-nothing-yet = Measure a target first. Then it can be followed through the pass.
measure-whole-looking = Following the points through the pass…
measure-whole-heading = Whole pass: not saved yet
measure-whole-height = Height
measure-whole-frames = Frames
measure-whole-frames-used = { $used } of { $all } used
measure-whole-speed = Speed
measure-whole-wheelbase = Wheelbase
measure-whole-dropped = { $count ->
    [one] { NUMBER($count) } point excluded: { $reason }
   *[other] { NUMBER($count) } points excluded: { $reason }
}
measure-whole-look = { $count ->
    [one] { NUMBER($count) } point was followed. Step through the frames and check that it stays in place.
   *[other] { NUMBER($count) } points were followed. Step through the frames and check that they stay in place.
}
measure-whole-keep = Save this height
measure-whole-leave = Cancel
measure-whole-said = From the whole pass; inset { $inset } (u = { $u_inset })
measure-whole-follow = Follow through the pass
measure-whole-go = Follows contact and target through the frames of the pass. Nothing is saved until you save the height.
measure-step-pass = whole pass
measure-followed-mark = { $point ->
    [contact] followed contact
    [second_contact] followed second tyre
   *[target] followed target
}
measure-followed-frame = { $used ->
    [yes] Frame { $frame }: contact and target were followed
   *[no] Frame { $frame }: contact or target was excluded
}
measure-frame = Frame { $frame }
measure-frame-first = first
measure-frame-remove = Remove frame { $frame }
measure-frame-remove-this = Remove this frame
measure-frame-removed = { $count ->
    [one] Frame { $frame } removed. { NUMBER($count) } frame left.
   *[other] Frame { $frame } removed. { NUMBER($count) } frames left.
}
measure-one-frame = One frame
measure-all-frames = { $count ->
    [one] { NUMBER($count) } frame
   *[other] { NUMBER($count) } frames
}
measure-gain-looking = { $which ->
    [second] Searching for the best second frame…
   *[another] Searching for the best further frame…
}
measure-gain = { $which ->
    [second] Second frame, U95: { $U95_now } → { $U95_then }
   *[another] Another frame, U95: { $U95_now } → { $U95_then }
}
measure-gain-go = Go to frame { $frame } and click the same two points

## Measure: the vehicle

measure-vehicle = Vehicle
measure-vehicle-number = Vehicle { $vehicle }
measure-vehicle-none = Choose a pass on the left. Its vehicle and measurements appear here.
measure-save-again = Save again
measure-record = Vehicle record
measure-facts-of = facts of vehicle { $vehicle }
recent-models-title = Recently used models
recent-models-taken = Make and model: { $model }
recent-models-gone = { $model } is no longer in the catalogue.
which-model-title = Models that fit
which-model-cannot = { $model } does not fit: { $differences } (measured minus catalogue). If the model were right, differences this large would have a probability of { $p }; the limit is { $limit }.
which-model-ranked = Ranked by { $sizes }. Measured heights are not used for ranking: they are compared with the model later.
which-model-by-name = No length of this vehicle is measured, so the models of its class come first, then by name. Click both tyres (Checks, Direction) to rank by wheelbase.
which-model-shown = The first { $shown } of { NUMBER($count) } are shown.
which-model-left-out = { $count ->
    [one] 1 model that does not fit the measured sizes is not shown.
   *[other] { NUMBER($count) } models that do not fit the measured sizes are not shown.
}
model-chosen-by-size = The model was chosen by its sizes ({ $sizes }). Its heights are not used as references until a person confirms the model on the vehicle.
model-chosen-see = Confirm the model
model-chosen-seen = The model was chosen by its sizes ({ $sizes }), then confirmed on the vehicle.
model-chosen-word-size = by its sizes
model-chosen-word-seen = confirmed on the vehicle
which-model-size-height = roof
which-model-size-length = length
which-model-size-width = width
which-model-size-wheelbase = wheelbase
which-model-size-taillight = taillight
which-model-size-headlight = headlight
measure-makers-height = Manufacturer’s height
measure-makers-height-u = Standard uncertainty
measure-year-problem = Enter a year from 1885 to { $most }.
measure-span = Frames of the pass
measure-span-first = First
measure-span-best = Best
measure-span-last = Last
measure-span-first-here = Set first
measure-span-best-here = Set best
measure-span-last-here = Set last
measure-span-elsewhere = Another recording is open.
measure-span-frame-problem = Enter a frame number.
measure-span-order = { $first_frame } is after { $last_frame }.
measure-span-choose = Choose { $first_frame } to { $last_frame }.
measure-span-move-best = Move best ({ $best_frame }) first.

## Measure: facts of a vehicle, and two people who changed the same

measure-field-first_frame = First frame
measure-field-best_frame = Best frame
measure-field-last_frame = Last frame
measure-field-make = Make
measure-field-model = Model
measure-field-year = Year
measure-field-model_chosen_by = How the model was chosen
measure-field-model_sizes = Sizes used to choose the model
measure-field-category = Category
measure-field-manufacturer_height_m = Manufacturer’s height
measure-field-u_manufacturer_height_m = u of the manufacturer’s height
measure-field-height_source = Source of the height
measure-field-known_driver_eye_m = Known height of the driver’s eye
measure-field-u_known_driver_eye_m = u of the known height of the driver’s eye
measure-field-known_driver_eye_source = Source of the known height of the driver’s eye
measure-field-known_taillight_m = Known height of the taillight
measure-field-u_known_taillight_m = u of the known height of the taillight
measure-field-known_taillight_source = Source of the known height of the taillight
measure-field-known_headlight_m = Known height of the headlight
measure-field-u_known_headlight_m = u of the known height of the headlight
measure-field-known_headlight_source = Source of the known height of the headlight
measure-field-known_other_m = Known height of the mark
measure-field-u_known_other_m = u of the known height of the mark
measure-field-known_other_source = Source of the known height of the mark
measure-field-check_target = Check target
measure-check-target-yes = yes
measure-check-target-no = no
measure-check-target-mark = check target
measure-known-title = Known heights
measure-known-help = Heights of the eye, the lamps or a mark, from a tape or a data sheet. Errors are computed against them. The roof height is entered above.
measure-known-some = { $count ->
    [one] 1 known
   *[other] { NUMBER($count) } known
}
measure-known-u = u
measure-known-source = Source
measure-known-mark = Mark
measure-check-target-help = A staff with marks, or a car with taped heights, driven past to check the measurement; on a staff, set the inset of each height to 0. It has its own row in the error tables and is excluded from distributions, quotas and response.
measure-check-target-empty = A check target needs a known height. Enter the roof height above, or another height here.
measure-field-lighting = Lighting
measure-field-direction = Direction
measure-field-driver_side = Driver’s side
measure-field-roof_not_visible = Roof not visible
measure-field-driver_eye_not_visible = Driver’s eye not visible
measure-field-taillight_not_visible = Taillight not visible
measure-field-headlight_not_visible = Headlight not visible
measure-field-discarded = Pass
measure-field-notes = { field-notes }
measure-in-sample = in the sample
measure-out-of-sample = outside the sample, by the survey’s rule
measure-discard-measured = Withdraw its measurements to discard it.
measure-fact = { $field ->
    [first_frame] first frame { $value }
    [best_frame] best frame { $value }
    [last_frame] last frame { $value }
    [make] make { $value }
    [model] model { $value }
    [year] year { $value }
    [model_chosen_by] model chosen: { $value }
    [model_sizes] model chosen by: { $value }
    [category] category { $value }
    [manufacturer_height_m] manufacturer’s height { $value }
    [u_manufacturer_height_m] u of the manufacturer’s height { $value }
    [height_source] source of the height { $value }
    [known_driver_eye_m] known height of the driver’s eye { $value }
    [u_known_driver_eye_m] u of the known height of the driver’s eye { $value }
    [known_driver_eye_source] source of the known height of the driver’s eye { $value }
    [known_taillight_m] known height of the taillight { $value }
    [u_known_taillight_m] u of the known height of the taillight { $value }
    [known_taillight_source] source of the known height of the taillight { $value }
    [known_headlight_m] known height of the headlight { $value }
    [u_known_headlight_m] u of the known height of the headlight { $value }
    [known_headlight_source] source of the known height of the headlight { $value }
    [known_other_m] known height of the mark { $value }
    [u_known_other_m] u of the known height of the mark { $value }
    [known_other_source] source of the known height of the mark { $value }
    [check_target] check target: { $value }
    [lighting] lighting { $value }
    [direction] goes { $value }
    [driver_side] driver on the { $value }
    [roof_not_visible] roof not visible: { $value }
    [driver_eye_not_visible] driver’s eye not visible: { $value }
    [taillight_not_visible] taillight not visible: { $value }
    [headlight_not_visible] headlight not visible: { $value }
    [discarded] { $value }
   *[notes] notes { $value }
}
measure-fact-empty = empty
measure-deleted = deleted
measure-merged = { $problem } Your changes are to other fields, so both are kept.
measure-conflict = Changed by another user
measure-conflict-kept = Both versions are kept until you choose.
measure-conflict-mine = mine: { $value }
measure-conflict-theirs = theirs: { $value }
measure-conflict-save = Save this
measure-conflict-changed = { $person } changed this vehicle on { $when }.
measure-conflict-measured = { $person } measured this target on { $when }.
measure-conflict-withdrawn = { $person } withdrew this measurement on { $when }.
measure-conflict-height-theirs = Theirs
measure-conflict-height-mine = Yours
measure-conflict-keep-theirs = Keep theirs
measure-conflict-save-mine = Save mine as a new revision
measure-conflict-withdraw = Withdraw it
measure-conflict-somebody = another user

## Review: the page

review-loading = the queue
review-back-to-frame = Back to frame { $frame }
review-none-in-state-title = Nothing in this state
review-none-in-state = Choose another state in the list on the left.
review-all-done-title = Everything is reviewed
review-all-done = Each measurement has a verdict. New and remeasured ones appear here automatically.
review-to-export = Go to Package
review-none-title = Nothing to review yet
review-none = Measurements appear here as soon as an operator has made them.
review-to-measure = Go to Measure
review-other-point = Choose the other point
review-other-frame = Not the measured frame
review-fix-hint = Drag a point, or press { $key } and nudge it with the arrows. Enter saves, Esc cancels.

## Review: the queue

review-queue = Queue
review-queue-title = Review <muted>{ NUMBER($count) } to review</muted>
review-queue-end = This is the end of the queue.
review-queue-start = This is the start of the queue.
review-queue-more = Show more
review-show = Show
review-state-to_review = To review
review-state-rejected = Rejected
review-state-accepted = Accepted
review-state-fixed = Fixed
review-state-all = All
review-counts = { NUMBER($accepted) } accepted, { NUMBER($rejected) } rejected of { NUMBER($count) }
review-counts-of-scans = { $count ->
    [one] (1 of line scans)
   *[other] ({ NUMBER($count) } of line scans)
}
review-mine = mine
review-line = line scan
review-verdict-of = verdict on { $target } of vehicle { $vehicle }
review-verdict-reason = { $verdict }: { $reason }
review-verdict-by = { $verdict } by { $person }
review-verdict-none = no verdict
review-verdict-kept = The verdict is kept in this browser and will be sent when the connection is back.

## Review: clicking again before the points are seen

review-plan = { $one_in ->
    [0] Blind check: off.
    [1] Blind check: every measurement is clicked before it is shown.
   *[other] Blind check: 1 measurement in { $one_in } is clicked before it is shown.
}
review-plan-name = Blind check
review-plan-choose = Blind check, for all reviewers of this survey
review-plan-choice = { $one_in ->
    [0] off
    [1] every one
   *[other] 1 in { $one_in }
}
review-blind-click = click it again
review-blind-title = Blind check: click it yourself first
review-blind-contact = Click the tyre contact, then the target. The points and the height are shown afterwards, beside yours.
review-blind-target = Now the target. Esc removes the contact.
review-blind-why = Independent blind clicks show how repeatable the measurements are. They are drawn at random. If one cannot be clicked, reject it and state the reason.
blind-kept = Your second click is kept in this browser and will be sent when the connection is back.
review-again = Clicked again
review-again-you = <strong>You</strong> clicked it again: <height>{ $height }</height>
review-again-person = <strong>{ $person }</strong> clicked it again: <height>{ $height }</height>
review-again-somebody = <strong>Another user</strong> clicked it again: <height>{ $height }</height>
review-again-take-back = Undo
review-again-agree = Agree: difference { $apart }, limit { $expected }
review-again-differ = Disagree: difference { $apart }, limit { $expected }
review-again-not-compared = Not compared

## Review: what is known of a measurement

review-measurement = Measurement
review-facts = Facts and history
review-contact = contact
review-pixels = { $point ->
    [contact] Pixels around the contact point
    [roof] Pixels around the roof point
    [driver_eye] Pixels around the driver’s eye point
    [taillight] Pixels around the taillight point
    [headlight] Pixels around the headlight point
   *[other] Pixels around the other target’s point
}
review-vehicle = Vehicle
review-vehicle-unknown = not known
review-manufacturer-height = Manufacturer’s height
review-lighting = Lighting
review-frame-at = { $frame }, { $time }
review-further-frames = Further frames
review-distance = Distance
review-inset = Inset
review-inset-estimate = { $inset } (u = { $u_inset }, estimate)
review-points-set = Points
review-made-by = { $made ->
    [snapped] contact snapped to the tyre, target clicked by { $person }, { $time }
    [confirmed] suggested, confirmed by { $person }, { $time }
    [moved] suggested, moved by { $person }, { $time }
   *[clicked] clicked by { $person }, { $time }
}

## Review: the verdict

review-look-only = View only. Reviewers decide.
review-own = You made this measurement, so another person reviews it.
review-pose-changed = The recording has a new camera pose since this was measured; the fix is computed with it.
review-fix-save = Save the fix
review-fix-nothing = Nothing has changed. Move a point first, or accept the measurement.
review-fix-leave = Cancel
review-fix-mine = Use my points
review-reopen = Reopen it
review-reject-why = Why is it rejected?
review-reject-words = In your own words
review-reason-contact = The contact is not where the tyre meets the road.
review-reason-point = The target point is off the feature.
review-reason-frame = Another frame shows it better.
review-reason-hidden = The feature is hidden.
review-reason-wrong = The wrong vehicle or target.
review-reason-side = The driver sits on the other side.
review-step-verdict = verdict on { $target ->
    [roof] roof
    [driver_eye] driver’s eye
    [taillight] taillight
    [headlight] headlight
   *[other] other target
} of vehicle { $vehicle }
review-step-overtaken = Nothing was changed: this measurement has since been withdrawn, changed or given another verdict.
review-step-not-again = Nothing was changed: undo gives neither a correction nor another person’s verdict again; accept the measurement if it is right, or reject it.
review-error = Height error
review-side = Driver’s side
review-signs = <strong>Check closely:</strong> { $signs }
review-sign = { $sign ->
    [large_u] large uncertainty
    [unusual] unusual height in this survey
    [far_from_maker] far from the manufacturer’s height
   *[new_operator] operator with few measurements
}
review-own-waiting = { $count ->
    [one] { NUMBER($count) } of your own measurements waits for another reviewer.
   *[other] { NUMBER($count) } of your own measurements wait for another reviewer.
}
review-neighbours = Neighbouring frames
review-neighbour = Frame { $frame }

## Repeats: the page

repeats-lead = { $people ->
    [1] Blind repeat measurements of the same targets: variation within one operator (repeatability). Variation between operators (reproducibility) is known once a second one repeats them.
   *[other] Blind repeat measurements of the same targets: variation within one operator (repeatability) and between operators (reproducibility).
}
repeats-loading = repeatability
repeats-not-compared = { $count ->
    [one] { NUMBER($count) } repeat is
   *[other] { NUMBER($count) } repeats are
} excluded: the camera pose or inset changed, or no height could be computed.
repeats-click-mine = Repeat 10 of my measurements
repeats-click-anybodys = Repeat 10 measurements by anyone
repeats-none-title = No repeat measurements yet
repeats-none = { $one_in ->
    [0] Repeat ten random measurements here, or turn on blind checks in Review.
    [1] Blind checks are on: every measurement is repeated in Review. Ten random ones can be repeated here as well.
   *[other] Blind checks are on: 1 measurement in { $one_in } is repeated in Review. Ten random ones can be repeated here as well.
} After ten repeats of your own work, your own click uncertainty can replace the default of 1 px. Repeats of other people’s work show the variation between operators.
repeats-no-result = Repeats are kept separate and do not affect results.
repeats-to-review = Go to Review
repeats-target = Target
repeats-items = { $count ->
    [one] { NUMBER($count) } item
   *[other] { NUMBER($count) } items
}

## Repeats: the table of targets

repeats-targets-title = Heights, by target
repeats-targets-note = Standard deviations with 95 % confidence intervals
repeats-targets-help = Values are pooled over all distances; the spread in millimetres grows with distance. Repeats on the same frame share lens, pose, board and inset errors, so only the click component of the uncertainty budget is compared. To include the other components, repeat on another frame.
repeats-clicked-again = Items repeated
repeats-same-person = Repeatability (s)
repeats-another-frame = Repeatability, other frame
repeats-another-person = Reproducibility (between operators)
repeats-claimed = Click uncertainty, stated
repeats-seen = Click uncertainty, observed
repeats-all-targets = All targets
repeats-people-differ = Significant operator × vehicle interaction (p < 0.05); it is included in repeatability.
repeats-ratio = × { $ratio } ({ $low } to { $high })
repeats-more = more than stated
repeats-less = less than stated
repeats-as = as stated

## Repeats: the table of people

repeats-people-title = Clicks, by operator
repeats-people-note = Standard deviation of each coordinate of a click, from own repeats
repeats-person = Operator
repeats-own = Own repeats
repeats-contact = Contact
repeats-height = Height
repeats-against-others = Mean difference from other operators
repeats-sigma = Click uncertainty used
repeats-sigma-usual = 1 px (default)
repeats-sigma-own = { $sigma_px } px (from repeats)
repeats-sigma-from = { $count ->
    [one] from { NUMBER($count) } repeat, chosen by { $person }
   *[other] from { NUMBER($count) } repeats, chosen by { $person }
}
repeats-sigma-use = Use { $sigma_px } px
repeats-sigma-use-title = { $count ->
    [one] By the heights of { NUMBER($count) } repeat; existing measurements keep the previous value
   *[other] By the heights of { NUMBER($count) } repeats; existing measurements keep the previous value
}
repeats-sigma-needs = Needs 10 own repeats
repeats-sigma-back = Back to 1 px

## Repeats: the figure of differences

anchoring-title = Effect of showing suggestions
anchoring-shown = Suggestions shown
anchoring-free = Suggestions hidden
anchoring-shift = Shift caused by suggestions
anchoring-goal = Goal: below { $goal }
anchoring-vehicles = { $count ->
    [one] 1 vehicle
   *[other] { NUMBER($count) } vehicles
}
anchoring-verdict = { $verdict ->
    [met] met: the whole 95 % CI is within the limit
    [missed] missed: the whole 95 % CI is outside the limit
   *[undecided] undecided: measure more vehicles with suggestions hidden
}
anchoring-plan = { $one_in ->
    [0] suggestions always shown
   *[other] suggestions hidden for 1 vehicle in { $one_in }
}
anchoring-plan-choose = Share of vehicles with suggestions hidden, drawn at random by the server
anchoring-help = For each vehicle: stored height minus height of the suggested points, on the same frame. The server draws at random for which vehicles suggestions are hidden, so the two groups differ only in whether suggestions are shown. The shift is the mean increase of stored heights when suggestions are shown (95 % CI, Welch). Heights measured by one person are not independent, so the result applies to the operators who measured here. It does not state how accurate the suggestions are.
anchoring-counts = With suggestions shown, { $confirmed } heights were confirmed, { $moved } moved and { $afresh } clicked by hand; all are included.
repeats-differences-title = Second minus first height, over their mean
repeats-differences-note = Bars show the expanded uncertainty of the difference (U95). About 95 % of the bars should include zero.
repeats-differences-label = { $count ->
    [one] Second minus first height in { $small } over their mean in { $unit }, { NUMBER($count) } repeat
   *[other] Second minus first height in { $small } over their mean in { $unit }, { NUMBER($count) } repeats
}
repeats-differences-x = Mean of both heights ({ $unit })
repeats-differences-y = Difference ({ $unit })

## Click again: measurements once more, without their points

again-loading = the blind repeats
again-place = <strong>{ $at } of { $of }</strong> <muted>vehicle { $vehicle }, { $target }</muted>
again-stored = { $count ->
    [one] { NUMBER($count) } repeat saved
   *[other] { NUMBER($count) } repeats saved
}
again-stop = Stop
again-undo = Undo last repeat
again-undo-clicks = second clicks
again-undo-skip = skipping
again-skip = Skip
again-results = View results
again-back-to-frame = Back to frame { $frame }
again-last-title = No more measurements to repeat
again-last = Each was saved as a repeat: repeats are kept separate and do not affect results.
again-none-own-title = No measurements of yours yet
again-none-title = No measurements yet
again-none-own = Measure some vehicles in this survey first. Then you can repeat your own measurements.
again-none = Measure some vehicles first. Then they can be repeated.
again-to-measure = Go to Measure
scans-lane-needs-boundaries = The vehicle was not measured yet, so it has no lane; place its boundaries first.

## Line scans: the page

scans-lead = Two line cameras at a known baseline give speed, length, acceleration and gaps, with the image of each vehicle.
scans-loading = the line scans
scan-live = This part of the stream is still being recorded; its image is available when it ends.
live-lead = Vehicles seen by the line cameras, and the state of the cameras.
live-loading = the live streams
live-none-title = No stream yet
live-none-pipe = Put the pixels per line, the baseline (m) and the line rate (Hz) of your own cameras into the command. On the computer at the cameras, pipe the recorder’s lines into it:
live-none-file = or follow a file that the recorder writes:
live-none-cameras = or read two GigE Vision cameras (with Aravis):
live-source-piped = Lines from a pipe
live-since = Since { $time }
live-state-running = recording
live-state-silent = no signal
live-state-ended = ended
live-state-stopped = stopped
live-stopped = The stream stopped unexpectedly. Last contact: { $time }. Vehicles up to then are stored. Recorded lines are on its computer: run the same command there to resume.
live-silent = Last contact { $ago }. Check its computer; the same command resumes the stream.
live-earlier = Earlier parts:
live-time = Recorded
live-lines = Lines
live-lost = Lines lost (1 / 2)
live-light = Road brightness
live-saturated = Saturated
live-clock = Delay
live-waiting = Waiting
live-memory = Memory
live-flow = Vehicles per minute
live-flow-last = { $time }: { $vehicles }
live-flow-none = no complete minute yet
live-flow-minute = { $time }: { $vehicles ->
    [one] { $vehicles } vehicle
   *[other] { $vehicles } vehicles
}
live-flow-part = { $time }: { $vehicles ->
    [one] { $vehicles } vehicle
   *[other] { $vehicles } vehicles
}, partly observed
live-vehicles = Latest vehicles
live-no-vehicles = No vehicles yet
live-picture-later = Images of vehicles are available when this part of the stream has ended and been imported.
scans-add = Add a line scan
scans-all = All line scans
scans-no-such-lane = The rig has no lane { $lane }; choose one of its lanes.
scans-none-title = No line scans yet
scans-none = An operator can upload the strips of both cameras here.
scans-delete-title = Delete { $scan }?
scans-delete-what = This deletes both strips and the vehicles found in them. A line scan with edited or reviewed vehicles cannot be deleted.
scans-delete = Delete the line scan
scans-delete-one = Delete { $scan }
scans-deleted = { $scan } was deleted.
scans-read-again = Import again
scans-not-read = The strips could not be imported.
scans-rig = Rig, and estimates from the traffic
scans-rig-change = Change the rig…
scans-open = Open
scans-fact-lines = { $lines ->
    [one] { $lines } line of { $rows_px } rows
   *[other] { $lines } lines of { $rows_px } rows
}
scans-start-words = { $start } (u = { $u_s } s)
scans-start-unknown = Start not known, so no vehicle has a time of day.
scans-start-edit-of = Change the start of { $recording }
scans-start-line = First line, local time
scans-start-hint = From the recorder’s clock, or from a watch held in front of camera 1 and your notes.
scans-start-from-video = The source video starts { $time } (as confirmed, otherwise as stated in its file).
scans-start-u = Standard uncertainty u
scans-start-u-hint = Shared by all vehicles. Example: 1 for a watch read by eye, 0.001 for lines stamped by GPS or PTP.
scans-start-u-problem = Enter the standard uncertainty of the start in seconds, more than 0.
scans-fact-baseline = baseline { $baseline }
scans-fact-rate = { $rate_hz } lines/s
scans-fact-video = cut from a video at { $along ->
    [columns] columns
   *[rows] rows
} { $cut_1_px } and { $cut_2_px }
scans-count-none = vehicles not searched yet
scans-count-vehicles = { $count ->
    [one] { NUMBER($count) } vehicle
   *[other] { NUMBER($count) } vehicles
}
scans-count-to-review = { NUMBER($count) } to review
scans-count-accepted = { NUMBER($count) } accepted
scans-count-rejected = { NUMBER($count) } rejected
scans-count-not-measurable = { NUMBER($count) } not measurable
scans-count-heights = { $count ->
    [one] { NUMBER($count) } height
   *[other] { NUMBER($count) } heights
}
scans-count-heights-to-review = { $count ->
    [one] { NUMBER($count) } height to review
   *[other] { NUMBER($count) } heights to review
}

## Line scans: what a line scan cannot measure

scans-limits = What a line scan cannot measure
scans-limit-opposing = Opposing direction
scans-limit-opposing-why = A vehicle that reaches camera 2 first is measured with the cameras exchanged. Its direction is shown and exported; its speed, time and gaps refer to camera 1, as for all vehicles. Two vehicles that pass each other in front of the cameras share their lines and are not measured.
scans-limit-abreast = Occlusion by parallel vehicles
scans-limit-abreast-why = Two vehicles that hide each other share their lines, so neither has a front and a rear of its own. They can be measured only when they pass separately: use a lane farther away, or a steeper view from above.
scans-limit-slow = Stopped, reversing, or very slow
scans-limit-slow-why = A strip records time, not distance. A stopped vehicle repeats the same line, and the fit assumes constant acceleration, so stop-and-go traffic cannot be measured.
scans-limit-cut = Cut off, or lines lost
scans-limit-cut-why = A vehicle cut off by the beginning or end of the recording has no front or no rear. Where the recorder lost lines, the time axis of the strip is wrong.
scans-limit-distance = Vehicles at another distance
scans-limit-distance-why = If the scanning planes are not exactly parallel, the baseline changes with distance, which the traffic alone cannot reveal. Enter the uncertainty of the divergence and the distance to the lane under Rig.

## Line scans: adding one

scans-new = A new line scan
scans-new-from = Source
scans-new-strips = Two strips
scans-new-video = Two columns or rows of a video
scans-new-name-hint = Empty: the file name is used.
scans-new-read = Import and find the vehicles
scans-new-no-strip = no strip uploaded yet
scans-new-choose-strip = choose a strip
scans-new-strip = { $file } ({ $size })
scans-new-choose-both = Choose both strips
scans-new-drop = Drop both strips here, or click to choose
scans-new-drop-hint = PNG, TIFF or BigTIFF, 8 or 16 bit greyscale, of any length.
scans-new-camera-1 = Camera 1, which a vehicle reaches first
scans-new-camera-2 = Camera 2
scans-new-same-strip = Both cameras cannot have the same strip.
scans-new-time-axis = Time runs along the image’s
scans-new-time-width = width (usual)
scans-new-time-height = height
scans-new-no-recording = no recording is ready
scans-new-choose-recording = choose a recording
scans-new-recording-hint = The frame rate becomes the line rate: use a constant, high frame rate.
scans-new-cut-along = Travel direction in the video
scans-new-cut-along-columns = Left or right: columns
scans-new-cut-along-rows_left_up = Up or down, roofs to the left: rows
scans-new-cut-along-rows_right_up = Up or down, roofs to the right: rows
scans-new-cut-1 = { $along ->
    [columns] Column
   *[rows] Row
} of camera 1
scans-new-cut-1-hint = The one that vehicles reach first.
scans-new-cut-1-hint-to = The one that vehicles reach first, 0 to { $last_px }.
scans-new-cut-2 = { $along ->
    [columns] Column
   *[rows] Row
} of camera 2

## Line scans: the rig

scans-rig-title = The rig
scans-rig-store = Save
scans-rig-traffic = Rig estimated from the traffic
scans-rig-traffic-title = From the traffic
scans-rig-note = Existing results keep the old values and are marked outdated until you measure again.
scans-rig-undo = the rig
scans-rig-stored = The rig was saved.
scans-rig-stored-older = The rig was saved. Find the vehicles again to update the results.
scans-rig-baseline = Baseline
scans-rig-baseline-hint = Between the two scanning planes, at the vehicles.
scans-rig-u = Standard uncertainty
scans-rig-baseline-u-hint = Limits the accuracy of every speed.
scans-rig-rate = Line rate
scans-rig-clock = Relative u of the line rate
scans-rig-clock-hint = Typical quartz: 50 ppm.
scans-rig-more = More: misalignment, divergence, distance to lane, shadow zone
scans-rig-misalignment = Misalignment
scans-rig-from-traffic = from the traffic
scans-rig-misalignment-hint = Row of a point in strip 2 minus its row in strip 1. Empty: estimated from the traffic, vehicle by vehicle.
scans-rig-divergence = Divergence angle between scanning planes
scans-rig-divergence-hint = Positive: the planes diverge towards the vehicles. The baseline is then that at the cameras.
scans-rig-divergence-u-hint = For planes set parallel: the uncertainty of the setting.
scans-rig-distance = Distance to lane (near side of vehicles)
scans-rig-distance-hint = Needed for the divergence only.
scans-lanes = Lanes at several distances
scans-lanes-why = Each vehicle is measured with the baseline at its own lane. A lane is identified by its direction and by the row at which tyres meet the road (camera 1, row 0 on top); you can also choose it for the vehicle. Without lanes, all vehicles are at the distance above.
scans-lane-of = Lane { $number }
scans-lane-name = Name of the lane
scans-lane-way = { $way ->
    [camera_1_first] camera 1 first
    [camera_2_first] camera 2 first
   *[either] either
}
scans-lane-distance = Distance to its vehicles (near side)
scans-lane-from = Tyres from row
scans-lane-to = Tyres to row
scans-lane-rows-hint = Leave both empty if the direction identifies the lane.
scans-lane-shadow-rig = as for the rig
scans-lane-add = Add a lane
scans-lane-remove = Remove this lane
scans-lane-problem-name = Enter a name of at most 40 characters.
scans-lane-problem-twice = Another lane has this name; enter another.
scans-lane-problem-distance = Enter a length above 0.
scans-lane-problem-rows = Enter both rows, the upper one (the smaller number) first, or leave both empty.
scans-rig-shadow = Shadow zone
scans-rig-shadow-hint = Lowest part of the image, with only road and shadows; vehicles are not searched there. A high camera close to the lane needs more.
scans-rig-problem-shadow = Enter a share from 0 to 60 %.
scans-rig-problem-number = Enter a number of 0 or more, or leave it empty.
scans-rig-problem-length = Enter a length, or leave it empty.
scans-rig-problem-angle = Enter an angle of at most 200 mrad, or leave it empty.
scans-rig-problem-baseline = Enter the distance between the two scanning planes.
scans-rig-problem-rate = Enter the line rate of the cameras.
scans-rig-problem-misalignment = Enter pixels, or leave it empty.
scans-rig-problem-distance = Enter the distance to the lane, or leave the divergence empty.
scans-rig-problem-misalignment-u = Enter the misalignment too, or leave its uncertainty empty.
scans-rig-distance-u-hint = Lateral spread of the vehicles; matters if the planes diverge.
scans-rig-correlation = Correlation of baseline and divergence
scans-rig-correlation-hint = From a calibration; cleared when you enter another baseline or divergence.
scans-rig-problem-correlation = Enter a number from −1 to 1, or leave it empty.
scans-calibrate = Calibrate the rig…
scans-calibrate-why = Baseline and divergence from a staff or board that passes both cameras at two distances.
scans-calibrate-title = Calibrate the rig
scans-calibrate-how = Move a staff or board past both cameras at two or more distances, several times each, for example in the near and the far lane. Keep its marks at mid-height of a vehicle.
scans-calibrate-way = Method
scans-calibrate-way-board = Board of known width
scans-calibrate-way-positions = Staff along a tape
scans-calibrate-way-speed = Staff at a known speed
scans-calibrate-hint-board = Carry an upright board past at a steady speed, along the traffic. Enter the lines of its first and last edge in both strips: its width gives its speed.
scans-calibrate-hint-positions = Move an upright staff along a tape that lies along the traffic. Enter where each camera sees it.
scans-calibrate-hint-speed = Enter the staff’s speed and its line in either strip; this needs the line rate of the cameras.
scans-calibrate-tape = Uncertainty of the tape’s scale
scans-calibrate-tape-hint = Standard uncertainty common to all taped lengths. Empty: none.
scans-calibrate-tape-problem = Enter 0 to 10 %.
scans-calibrate-distance-problem = Enter the distance to the vehicles: speeds use the baseline there.
scans-calibrate-compute = Compute
scans-calibrate-busy = the calibration
scans-calibrate-store = Apply
scans-calibrate-answer = Result of the passes
scans-calibrate-lane = Baseline at the lane, { $distance }
scans-calibrate-share = ({ $percent } % of every speed)
scans-calibrate-baseline = Baseline at the cameras
scans-calibrate-agree = Consistency of the passes
scans-calibrate-chi2 = chi-square { $chi2 }, { $degrees ->
    [one] 1 degree
   *[other] { NUMBER($degrees) } degrees
 } of freedom: p = { $percent } %
scans-calibrate-mrad = { $value } ± { $U95 } mrad
scans-calibrate-passes = Passes and residuals
scans-calibrate-span = Baseline there
scans-calibrate-residual = Residual
scans-calibrate-history = Calibrations
scans-calibrate-one = { $number }, by { $who }, { $passes } passes
scans-calibrate-in-force = current
scans-calibrate-use-one = Use calibration { $number }
scans-passes = Passes
scans-passes-typed = passes as entered
scans-passes-number = Pass
scans-passes-cell = Pass { $number }, { $column }
scans-passes-add = Add a pass
scans-passes-choose = CSV of passes
scans-passes-drop = Or drop a CSV of passes
scans-passes-drop-hint = One pass per row, with the columns of “sightline rig calibrate”.
scans-passes-refused = Row { $row } is skipped.
scans-passes-distance-shown = Distance
scans-passes-head-distance_m = Distance, m
scans-passes-u = u
scans-passes-head-width_m = Width, m
scans-passes-head-position_1_m = At camera 1, m
scans-passes-head-position_2_m = At camera 2, m
scans-passes-head-speed_mps = Speed, m/s
scans-passes-head-line_1 = Line, strip 1
scans-passes-head-line_2 = Line, strip 2
scans-passes-head-front_line_1 = First edge, strip 1
scans-passes-head-rear_line_1 = Last edge, strip 1
scans-passes-head-front_line_2 = First edge, strip 2
scans-passes-head-rear_line_2 = Last edge, strip 2
scans-passes-head-u_line = u of a line

## Line scans: the rig as the traffic says it

scans-traffic-loading = the estimates from the traffic
scans-traffic-swapped = The cameras were swapped; the vehicles are being searched again.
scans-traffic-swap = Swap the cameras
scans-traffic-table = Estimates from the traffic
scans-traffic-says = Parameter
scans-traffic-value = Estimate (u)
scans-traffic-from = Vehicles
scans-traffic-in-force = Current
scans-traffic-take = Use
scans-traffic-gain = Brightness, camera 2 / camera 1
scans-traffic-gain-own = per vehicle
scans-traffic-baseline = { $of ->
    [length] Baseline by lengths
   *[wheelbase] Baseline by wheelbases
}
scans-traffic-note = u is the standard uncertainty. Estimates are not applied automatically. Choose Use, then save.
scans-traffic-use = Use…
scans-traffic-use-for = Use this for { $what }

## Line scan: the bench

scan-loading = the line scan
scan-vehicles = Vehicles
scan-head-vehicle = Vehicle
scan-calibrate = Calibrate height
scan-rig = Rig…
scan-find = Find the vehicles…
scan-nothing-found-title = No vehicle was found
scan-nothing-yet-title = No vehicles yet
scan-nothing-found = Check the strips. Add a missed vehicle with two clicks: its front and its rear.
scan-nothing-yet = Find the vehicles to measure front, rear, speed, length and gaps automatically.
scan-find-now = Find the vehicles
scan-none-choose = Choose a line scan
scan-on = Forward along the strips
scan-back = Back along the strips
scan-on-window = Forward one window
scan-back-window = Back one window
scan-to-first = To the first line
scan-to-last = To the last line
scan-next-vehicle = Next vehicle
scan-previous-vehicle = Previous vehicle
scan-take-out-vehicle = Remove the vehicle
scan-last-vehicle = This is the last vehicle.
scan-first-vehicle = This is the first vehicle.
scan-search-stopped = The search stopped.

## Line scan: finding the vehicles

scan-find-title = Find the vehicles
scan-find-and-measure = Find and measure
scan-find-again = Measure again
scan-find-method = Method
scan-find-direct = Direct registration
scan-find-paper = Block matching (Douxchamps et al.)
scan-find-direct-what = Registers both strips of a vehicle as a whole: speed, acceleration and the cameras’ misalignment in one fit. The default.
scan-find-paper-what = Block matching and linear regression, as published by Douxchamps, Macq and Chihara; for comparison.
scan-find-what = Scope
scan-find-all = Search the whole recording
scan-find-known = Measure the known vehicles again
scan-find-note = Manual boundaries and removed vehicles are kept. Accepted results that change return to review.

## Line scan: the strips, and what the next click is to hit

scan-strips = line-scan strips
scan-strips-label = Camera 1 above, camera 2 below, time to the right
scan-camera-1 = camera 1
scan-camera-2 = camera 2
scan-strips-missing = Part of the image could not be loaded.
scan-asked = { $what } (Esc stops)
scan-asked-stretch = { $what } (R stretches, Esc stops)
scan-click-camera-1 = Click on camera 1, the upper strip.
scan-click-rod-distance = Enter the rod distance on the right
scan-click-rod = Click the rod { $distance } away, { $height } above the road
scan-click-tyre = Click a tyre contact point on camera 1
scan-click-target = { $target ->
    [roof] Click { target-hint-roof }
    [driver_eye] Click { target-hint-driver_eye }
    [taillight] Click { target-hint-taillight }
    [headlight] Click { target-hint-headlight }
   *[other] Click { target-hint-other }
}
scan-click-any-target = Click the target
scan-click-front-wheel = Click the hub of the front wheel on camera 1
scan-click-rear-wheel = Click the hub of the rear wheel on camera 1
scan-click-front = Click the vehicle’s front on camera 1
scan-click-rear = Click the vehicle’s rear on camera 1
scan-drawn-height = { $target } { $height }
scan-drawn-away = { $distance } away
scan-drawn-mark-away = { $height }, { $distance } away

## Line scan: the table of vehicles

scan-head-number = No.
scan-head-time = Time
scan-head-clock = Time of day
scan-time-title = { $time }; { $since } after the first line
scan-head-speed = Speed
scan-head-acceleration = Acc.
scan-head-length = Length
scan-head-gap = Gap
scan-head-distance-gap = Distance gap
scan-head-headway = Headway
scan-head-state = State
scan-choose-vehicle = { $vehicle } <hidden>choose</hidden>

## Line scan: the chosen vehicle

scan-vehicle = Vehicle
scan-vehicle-none = Choose a vehicle in the list or on the strips{ $key }. Its motion, fit and gaps appear here.
scan-vehicle-body = Motion and history
scan-fit-loading = the fit
scan-motion = Motion
scan-not-measurable = Not measurable
scan-older = Outdated: the rig values changed. Measure again.
scan-length = Length
scan-acceleration = Acceleration
scan-wheelbase = Wheelbase
scan-wheelbase-none = not clicked
scan-axles = Axles
scan-axles-of = { $count ->
    [0] { $by ->
        [person] none, corrected by hand
       *[machine] no wheel found
    }
   *[other] { NUMBER($count) }, { $by ->
        [person] corrected by hand
       *[machine] found by Sightline
    }
}
scan-axles-correct = Correct the axles
scan-axles-title = Click a hub to add an axle, a line to remove it
scan-axles-again = Find the axles again
scan-click-axle = Click the hub of a wheel to add its axle, or the line of one to remove it; Esc ends.
scan-step-lane = lane of vehicle { $vehicle }
scan-step-axles = axles of vehicle { $vehicle }
scan-passed = Passed
scan-passed-at = { $day }, { $time }
scan-passed-within = { $time } ± { $U95_s } s
scan-passed-unknown = Time of day unknown: the start of the recording is not confirmed
scan-lane = Lane
scan-lane-unknown = lane not known
scan-lane-of = { $lane }, { $by ->
    [person] chosen by hand
   *[machine] found by Sightline
}
scan-lane-tyres = (tyres at row { $row })
scan-lane-choose = Choose the lane
scan-lane-by-program = as found by Sightline
scan-direction = Direction
scan-direction-of = { $direction ->
    [camera_2_first] camera 2 first
   *[camera_1_first] camera 1 first
}
scan-time-gap = Time gap (rear to front)
scan-time-gap-first = the first vehicle
scan-distance-gap = Distance gap (clearance, rear to front)
scan-distance-gap-paper = { $gap } <muted>(by mean speed { $paper_gap })</muted>
scan-headway = Time headway (front to front)
scan-by = By
scan-cause = { $method ->
    [paper] block matching
   *[direct] direct registration
}
scan-cause-by-hand = { $method ->
    [paper] block matching, boundaries placed by hand
   *[direct] direct registration, boundaries placed by hand
}
scan-cause-scatter = { $cause }; standard deviation of the blocks { $percent } %
scan-misalignment = Misalignment
scan-misalignment-u = { $value_px } px (u = { $u_px } px)
scan-show = Show
scan-show-title = Fill the window
scan-wheels = Click the wheels
scan-wheels-again = Click the wheels again
scan-wheels-title = Click both hubs
scan-heights-measure = Measure heights
scan-heights-title = Click a tyre’s contact, then roof, eye and lamp
scan-evidence = Evidence file
scan-evidence-title = Evidence file of vehicle { $vehicle }
scan-evidence-what = One page with both images, times, rig, motion, uncertainty budget, decision and signature. It opens without a server, lets the reader set other boundaries, and checks itself.
scan-evidence-make = Make the file
scan-evidence-limit-of = Quantity with a limit
scan-evidence-none = No limit
scan-evidence-speed = Speed
scan-evidence-time_gap = Time gap
scan-evidence-distance_gap = Distance gap
scan-evidence-most = Limit: at most
scan-evidence-least = Limit: at least
scan-evidence-risk = Risk of a false decision
scan-evidence-risk-hint = A smaller risk gives a wider guard band, within which no decision is made. Only accepted measurements are decided.
scan-evidence-source = Source of the limit
scan-evidence-source-hint = As it should appear in the file: the sign, order or rule.
scan-evidence-problem = Enter a limit and a risk above 0.
scan-take-out = Remove
scan-take-out-title = Remove the vehicle

## Line scan: what is known of a vehicle, its budget and its history

scan-known = Reference values of the vehicle
scan-known-make = Make
scan-known-model = Model
scan-known-length = Reference length
scan-known-wheelbase = Reference wheelbase
scan-known-problem = Enter a length.
scan-shadow-zone = shadow zone: not searched
scan-known-off = measured { $difference }

scan-references = Reference measurements
scan-references-none = None yet. Enter a value from a radar, GPS or the car’s speedometer.
scan-reference-speed = Speed
scan-reference-length = Length
scan-reference-wheelbase = Wheelbase
scan-reference-source-counter = speedometer
scan-reference-source-radar = radar
scan-reference-source-laser = laser gun
scan-reference-source-gps = GPS
scan-reference-source-loop = induction loop
scan-reference-source-tape = tape
scan-reference-source-other = other
scan-reference-says = { $quantity }, { $source }: { $value }
scan-reference-nothing = No measured value to compare with.
scan-reference-within = Difference { $difference }, within ± { $U95 }.
scan-reference-outside = Difference { $difference }, outside ± { $U95 }.
scan-reference-add = Add a reference
scan-reference-import = Import CSV
scan-reference-edit = Edit
scan-reference-edit-one = Edit { $quantity }, { $source }
scan-reference-remove-one = Remove { $quantity }, { $source }
scan-reference-add-title = Reference for vehicle { $vehicle }
scan-reference-edit-title = Correct a reference for vehicle { $vehicle }
scan-reference-store = Save
scan-reference-quantity = Quantity
scan-reference-source = Measured by
scan-reference-value = Value
scan-reference-u = Standard uncertainty (k = 1)
scan-reference-device = Instrument (optional)
scan-reference-value-problem = Enter a number above 0.
scan-reference-u-problem = Enter an uncertainty above 0.
scan-reference-note-speed = Compared with the speed at which the front reaches camera 1. A reference taken elsewhere needs a larger uncertainty.
scan-reference-note-length = Compared with the length or wheelbase measured here, both uncertainties combined.
scan-run-of = Run of car
scan-run-of-hint = The same name on several vehicles marks them as runs of one car.
scan-run-of-problem = Enter 100 characters at most.
scan-references-title = Import reference measurements
scan-references-choose = Choose a CSV
scan-references-drop = Drop a CSV here
scan-references-hint = Columns: number (or time: 14:05:32.4), source, speed_kmh, u_speed_kmh; also length_m, u_length_m, wheelbase_m, device, run_of
scan-references-looking = the file
scan-references-store = { $count ->
    [one] Import { NUMBER($count) } line
   *[other] Import { NUMBER($count) } lines
}
scan-references-done = { $values } reference { $values ->
    [one] value
   *[other] values
} and { $cars } car { $cars ->
    [one] name
   *[other] names
} imported.
scan-references-lines = Lines of the file
scan-references-line = Line
scan-references-vehicle = Vehicle
scan-references-given = Given
scan-references-what = Action
scan-references-why = Reason
scan-references-new = new
scan-references-replaces = replaces
scan-references-same = already there
scan-references-ambiguous = ambiguous
scan-references-refused = refused
scan-references-time = Time given
scan-references-apart = Difference
scan-references-by-time = { $number } (by time)
scan-references-tolerance = Time tolerance
scan-references-tolerance-hint = A line without a number is matched to the one vehicle that passed within this time.
scan-references-tolerance-problem = Enter a number of seconds above 0, up to 60.
scan-references-one = { $quantity } { $value }, u = { $u }
scan-budget-note = standard uncertainties
scan-budget = Uncertainty budget
scan-budget-source = Source
scan-budget-speed = Speed
scan-budget-acceleration = Acceleration
scan-budget-length = Length
scan-history = History ({ NUMBER($count) })
scan-revision = <strong>{ $speed }</strong>, { $length } <muted>{ $cause }</muted>
scan-revision-who = { $person }, { $time }
scan-revision-verdict = { $verdict ->
    [accepted] { $person }, { $time }; accepted by { $reviewer }
    [rejected] { $person }, { $time }; rejected by { $reviewer }
   *[reopened] { $person }, { $time }; reopened by { $reviewer }
}
scan-revision-verdict-why = { $verdict ->
    [accepted] { $person }, { $time }; accepted by { $reviewer }: { $reason }
    [rejected] { $person }, { $time }; rejected by { $reviewer }: { $reason }
   *[reopened] { $person }, { $time }; reopened by { $reviewer }: { $reason }
}
scan-by-search = Sightline
scan-by-somebody = another user

## Line scan: the fit of a vehicle

scan-profile-title = Speed along the vehicle
scan-profile-says = { $count ->
    [one] Speed of { NUMBER($count) } block along vehicle { $vehicle } and the fitted motion
   *[other] Speed of { NUMBER($count) } blocks along vehicle { $vehicle } and the fitted motion
}
scan-profile-none = No speed profile: the vehicle has no measured motion.
scan-profile-fitted = Fitted motion
scan-profile-used = Block, used
scan-profile-left-out = Block, excluded
scan-profile-note = Each block’s mean speed between the cameras.
scan-profile-beyond = { $count ->
    [one] { NUMBER($count) } block lies outside this plot; the CSV contains all.
   *[other] { NUMBER($count) } blocks lie outside this plot; the CSV contains all.
}
scan-profile-x = Time after the front reached camera 1 (s)
scan-match-title = Registration: strip 2 over strip 1
scan-match-picture = Image of the registration
scan-match-first = 1
scan-match-second = 2
scan-match-blink = blink
scan-match-difference = difference
scan-match-alt-first = The vehicle on camera 1
scan-match-alt-second = The vehicle on camera 2
scan-match-alt-difference = Difference of the two strips; uniform grey where they agree
scan-match-note = Strip 2 is shifted by the fitted speed and acceleration. Uniform grey: identical. Rotating wheels and the background seen through windows do not match.

## Line scan: the verdict

scan-reason-boundary = A boundary is not at the front or rear of the vehicle.
scan-reason-not-one = It is not one vehicle.
scan-reason-match = The strips do not match.
scan-verdict-mine = You placed these boundaries, so another person reviews them.
scan-verdict-given = { $verdict ->
    [accepted] Accepted by { $person }
   *[rejected] Rejected by { $person }
}
scan-verdict-given-why = { $verdict ->
    [accepted] Accepted by { $person }: { $reason }
   *[rejected] Rejected by { $person }: { $reason }
}
scan-verdict-done = Vehicle { $vehicle }: { $verdict ->
    [accepted] accepted.
   *[rejected] rejected.
}
scan-verdict-none-left = No other vehicle of this line scan waits for your verdict.
scan-verdict-reopen = Reopen

## Line scan: heights

scan-heights = Heights
scan-heights-camera = camera at { $height }
scan-heights-older = { $count ->
    [one] { NUMBER($count) } height of this line scan is outdated: the calibration or an inset changed.
   *[other] { NUMBER($count) } heights of this line scan are outdated: the calibration or an inset changed.
}
scan-heights-no-pose = Heights need the pose of camera 1. Record a rod with marks, or a checkerboard, held upright at two distances in its plane; then click the marks.
scan-heights-calibrate = Calibrate the height
scan-heights-calibrate-first = Heights need the line camera’s pose; calibrate the height with a rod first.
scan-height-hide = { $target ->
    [roof] Hide the details of the roof
    [driver_eye] Hide the details of the driver’s eye
    [taillight] Hide the details of the taillight
    [headlight] Hide the details of the headlight
   *[other] Hide the details of the other target
}
scan-height-show = { $target ->
    [roof] Show the details of the roof
    [driver_eye] Show the details of the driver’s eye
    [taillight] Show the details of the taillight
    [headlight] Show the details of the headlight
   *[other] Show the details of the other target
}
scan-height-measure = { $target ->
    [roof] Measure: roof
    [driver_eye] Measure: driver’s eye
    [taillight] Measure: taillight
    [headlight] Measure: headlight
   *[other] Measure: other target
}
scan-height-measure-again = { $target ->
    [roof] Measure again: roof
    [driver_eye] Measure again: driver’s eye
    [taillight] Measure again: taillight
    [headlight] Measure again: headlight
   *[other] Measure again: other
}
scan-heights-waiting = { $count ->
    [one] { NUMBER($count) } height to review
   *[other] { NUMBER($count) } heights to review
}
scan-height-unsaved = not yet saved…
scan-height-older = Outdated: the calibration or the inset changed. Compute again.
scan-height-again = Compute again
scan-height-withdraw = Withdraw
scan-height-side-first = Set the driver’s side first; the eye height depends on it.
scan-height-inset-driver_eye = Driver’s side
scan-height-inset-roof = Roof point
scan-height-distance = Lateral distance
scan-height-inset = Inset
scan-height-inset-value = { $inset } (u = { $u_inset }), estimate
scan-height-rows = Rows
scan-height-rows-value = contact { $contact_px }, target { $target_px }

## Line scan: the rod, which calibrates the height

scan-rod-title = Calibrate the height
scan-rod-label = Calibration of the height
scan-rod-body = Marks of the rod
scan-rod-none-title = No marks yet
scan-rod-none = Enter the distance of the rod from camera 1, then click its marks from the foot up. Repeat at another distance.
scan-rod-next = Next mark
scan-rod-distance_m = Rod distance
scan-rod-height_m = Mark height
scan-rod-step_m = Height step
scan-rod-next-note = Distances are horizontal, from the camera centre. An upright checkerboard can be used too: the height step is then its square size.
scan-rod-marks = Marks
scan-rod-head-distance = Distance
scan-rod-head-height = Height
scan-rod-head-row = Row
scan-rod-head-residual = Residual
scan-rod-head-remove = Remove
scan-rod-remove = Remove mark { $number }
scan-rod-result = Result of the marks
scan-rod-camera-height = Camera height
scan-rod-residuals = Residuals
scan-rod-rms = { $rms_px } px rms
scan-rod-store = Save the calibration
scan-rod-clear = Remove all marks
scan-rod-reset = Reset to saved
scan-rod-u = Standard uncertainties
scan-rod-u-row = u of a mark’s row
scan-rod-u-distance = u of a distance
scan-rod-u-lean = u of the rod’s tilt
scan-rod-at-least = Enter a number from { $least }.
scan-rod-distance-first = Enter the rod distance first, then click its marks.
scan-rod-stored = Calibration saved. Choose a vehicle and measure its heights.
scan-rod-kept = The calibration is kept in this browser and will be sent when the connection is back.
scan-rod-stored-older = Calibration saved. Existing heights keep the previous one until you compute them again.

## Line scan: steps that can be taken back, and what is kept until it is sent

scan-step-mark = mark of the rod
scan-step-mark-removed = removing a mark
scan-step-marks-removed = removing all marks
scan-step-calibration = calibration of the height
scan-step-boundaries = boundaries of vehicle { $vehicle }
scan-step-wheels = wheels of vehicle { $vehicle }
scan-step-known = reference values of vehicle { $vehicle }
scan-step-take-out = removal of vehicle { $vehicle }
scan-step-vehicle = vehicle { $vehicle }
scan-step-height = { $target ->
    [roof] roof of vehicle { $vehicle }
    [driver_eye] driver’s eye of vehicle { $vehicle }
    [taillight] taillight of vehicle { $vehicle }
    [headlight] headlight of vehicle { $vehicle }
   *[other] other target of vehicle { $vehicle }
}
scan-step-withdraw = { $target ->
    [roof] withdrawing the roof of vehicle { $vehicle }
    [driver_eye] withdrawing the driver’s eye of vehicle { $vehicle }
    [taillight] withdrawing the taillight of vehicle { $vehicle }
    [headlight] withdrawing the headlight of vehicle { $vehicle }
   *[other] withdrawing the other target of vehicle { $vehicle }
}
scan-taken-out = Vehicle { $vehicle } removed. Ctrl+Z undoes this.
scan-kept-vehicle = The vehicle is kept in this browser and appears in the list when the connection is back.
scan-wish-a-vehicle = a vehicle
scan-wish-verdict = verdict on vehicle { $vehicle }
scan-wish-lines = front at line { $front }, rear at line { $rear }
scan-wish-clicked = clicked at line { $line }, row { $row }
scan-wish-marks = { $count ->
    [one] { NUMBER($count) } mark at { $distances }
   *[other] { NUMBER($count) } marks at { $distances }
}
scan-wish-no-marks = none
scan-wish-there = in the list
scan-wish-taken-out = removed
scan-wish-boundaries = boundaries at lines { $lines }
scan-wish-hubs = wheels at lines { $lines }
scan-wish-lane = lane { $lane }
scan-wish-axles = { NUMBER($count) } axles
scan-wish-no-line = none
scan-wish-nothing-known = none

## Motion: what the line scans of a survey say together

motion-lead = Traffic, speeds, gaps, lengths and heights of every line scan of this survey, and agreement with known lengths and wheelbases, and with reference values.
motion-loading = the statistics
motion-which = Vehicles included
motion-which-accepted = Accepted
motion-which-all = Include unreviewed
motion-none-accepted-title = No accepted vehicles yet
motion-none-accepted = Review some in Line scans, or include unreviewed vehicles.
motion-none-title = No measured vehicles yet
motion-none = Add a line scan and find its vehicles.
motion-filter = Time of filming
motion-without-time = { $count ->
    [one] { NUMBER($count) } vehicle is excluded because the start of its line scan is not confirmed. <link>Confirm it in Line scans</link>
   *[other] { NUMBER($count) } vehicles are excluded because the starts of their line scans are not confirmed. <link>Confirm them in Line scans</link>
}
motion-none-filmed = No vehicle was filmed at this time.
motion-counted = { $vehicles ->
    [one] { $vehicles } vehicle
   *[other] { $vehicles } vehicles
} in { $scans ->
    [one] { $scans } line scan
   *[other] { $scans } line scans
}.
motion-counted-of = { $vehicles } of { $all ->
    [one] { $all } vehicle
   *[other] { $all } vehicles
} in { $scans ->
    [one] { $scans } line scan
   *[other] { $scans } line scans
}; { $left }.
motion-left-to_review = { $count ->
    [one] { NUMBER($count) } waits for review
   *[other] { NUMBER($count) } wait for review
}
motion-counter-braking = braking
motion-left-rejected = { NUMBER($count) } rejected
motion-left-not_measurable = { NUMBER($count) } cannot be measured
motion-heights = Heights of scanned vehicles
motion-heights-target = Target
motion-heights-mean = Mean
motion-heights-sd = SD
motion-heights-median = Median
motion-heights-u95 = Typical U95
motion-heights-to-review = To review
motion-heights-rejected = Rejected
motion-heights-waiting = { $count ->
    [one] { NUMBER($count) } height waits for a verdict
   *[other] { NUMBER($count) } heights wait for a verdict
}
motion-by-lengths = By lengths
motion-by-wheelbases = By wheelbases

## Motion: errors against known sizes

motion-errors-title = Error against manufacturers’ lengths and wheelbases
motion-errors-note = with 95 % intervals
motion-errors-scatter = The intervals show the scatter of these errors only, without the baseline’s error, which all vehicles share. Wheels are clicked, and with few vehicles the errors of the clicks do not average out: they can shift a bias out of its interval.
motion-errors-table = Errors of lengths and wheelbases
motion-errors-of = Quantity
motion-errors-n = n
motion-bias_m = Bias
motion-mae_m = MAE
motion-rmse_m = RMSE
motion-sd_m = SD
motion-length-daytime = Length, daytime
motion-length-low_light = Length, low light
motion-length-overall = Length, overall
motion-wheelbase-daytime = Wheelbase, daytime
motion-wheelbase-low_light = Wheelbase, low light
motion-wheelbase-overall = Wheelbase, overall
motion-errors-none = No vehicle has a known size.

motion-references-title = Difference from reference measurements
motion-references-note = measured minus reference
motion-references-of = Reference
motion-references-n = n
motion-references-mean = Mean
motion-references-share = Within combined U95
motion-references-by = { $quantity }, { $source }
motion-references-all = all sources
motion-references-within = { $within } of { $n }
motion-references-percent = { $percent } %
motion-references-shared = About 95 % should be within their combined U95. Vehicles of one rig share the error of its baseline, so several may be outside together.

motion-cars-title = Runs of one car
motion-cars-note = length and wheelbase must agree from run to run
motion-cars-runs = { $count ->
    [one] { NUMBER($count) } run: { $vehicles }.
   *[other] { NUMBER($count) } runs: { $vehicles }.
}
motion-cars-speed = Mean speed { $mean }, SD { $sd }.
motion-cars-speed-one = Speed { $mean }.
motion-cars-table = Runs of { $car } combined
motion-cars-size = Size
motion-cars-mean = Mean
motion-cars-stated = Stated u of a run
motion-cars-chi-square = Chi-square
motion-cars-chi = { $chi_square } ({ $degrees } d.f., p = { $p })
motion-cars-says = Runs
motion-cars-agree = Consistent with the stated uncertainties.
motion-cars-too_far_apart = Differ by more than stated: check the boundaries, and whether it is the same car.
motion-cars-too_alike = Differ by less than stated: the stated u is too large.
motion-cars-too_few = One run; two are needed.

## Motion: distributions

motion-speed = Speed as the front reaches camera 1
motion-length = Length
motion-time_gap = Time gap, rear to front
motion-distance_gap = Distance gap, rear to front
motion-headway = Headway, front to front
motion-percentile = P{ $percent } = { $value }
motion-percentile-interval = P{ $percent } = { $value } ({ $low } to { $high })
motion-spread-says = { $count ->
    [one] Cumulative distribution of { NUMBER($count) } vehicle; { $percentiles } { $unit }
   *[other] Cumulative distribution of { NUMBER($count) } vehicles; { $percentiles } { $unit }
}
motion-spread-note = Percentiles in { $unit }, with 95 % intervals: { $percentiles }.

## Motion: the paper's table

flows-title = Traffic by time of day
flows-note = Flow, headways and occupancy include all vehicles found; speeds and lengths include the measured vehicles selected above.
flows-lane = { $name }, { $lane }
flows-direction = { $scan }: { $direction ->
    [camera_2_first] camera 2 first
   *[camera_1_first] camera 1 first
}
flows-minutes = Interval
flows-minutes-of = { $minutes } min
flows-loading = the traffic
flows-table = Traffic of { $scan }
flows-table-note = Below each value: its standard uncertainty u (k = 1), or its 95 % interval. The interval of a flow assumes independent arrivals. Near: within its U95 of the start or end of the interval, or of a limit of the class; the vehicle may belong to the next. Length classes: the four of England’s trunk road counters.
flows-few = Plots are drawn from three intervals on: with intervals of this length they need a line scan of about { NUMBER($enough) } min. The table has what was recorded.
flows-unplaced = { $count ->
    [one] { NUMBER($count) } vehicle was not measured, has no time, and is in no interval.
   *[other] { NUMBER($count) } vehicles were not measured, have no time, and are in no interval.
}
flows-columns = Columns of the traffic of { $scan }
flows-columns-flow = Flow
flows-columns-speeds = Speeds and headways
flows-columns-lengths = Length classes
flows-head-from = From
flows-head-watched = Observed
flows-head-vehicles = Vehicles
flows-head-flow = Flow
flows-head-measured = Speeds
flows-head-time-mean = Time mean
flows-head-space-mean = Space mean
flows-head-occupancy = Occupancy
flows-head-density = Density
flows-head-unclassed = No length
flows-partial = partial
flows-refused = { NUMBER($count) } not measurable
flows-near-edge = { NUMBER($count) } near its start or end
flows-axles = { $axles } axles: { NUMBER($count) }
flows-axles-many = 5 or more
flows-near-limit = { NUMBER($count) } near a limit
flows-u = u = { $u }
flows-axis-time = Time of day
flows-flow = Flow
flows-flow-of = Flow, { $scan }
flows-flow-says = Flow in { NUMBER($count) } intervals; maximum { $flow } an hour, from { $time }.
flows-flow-note = Thick: flow in intervals of { $minutes } min, over the time observed; thin: its 95 % interval.
flows-speed = Speed
flows-speed-of = Speed, { $scan }
flows-speed-says = Space mean speed in { NUMBER($count) } intervals.
flows-speed-note = Thick: space mean speed; thin: 15th to 85th percentile of the speeds.
flows-speed-none = No interval contains an accepted speed.
flows-flow-by-density-of = Flow against density, { $scan }
flows-speed-by-flow-of = Speed against flow, { $scan }
flows-fundamental-says = Fundamental diagram: { NUMBER($count) } intervals with a speed.
flows-fundamental-note = Each point is an interval; open points were observed only in part. Density is flow over space mean speed.
unit-per-hour = 1/h
unit-per-km = 1/km
motion-paper-title = Layout of Table I, Douxchamps et al.
motion-paper-own = Vehicles of this survey
motion-paper-printed = Table I of Douxchamps et al., as printed
motion-head-vehicle = Vehicle
motion-head-car = Car in Table I
motion-head-speed = Speed
motion-head-acceleration = Acc.
motion-head-size = Length
motion-head-counter = Speedometer
motion-head-reference = Reference speed
motion-head-true = Known length
motion-head-fit-error = Fit error (%)

## Statistics: the page

results-heights = Heights and standards
results-errors = Errors
results-conclusion = Conclusion
results-paper = As in the paper
results-paper-help = Shows corrected and uncorrected percentiles, densities and the rows of Dupuis et al. beside the true heights.
statistics-filter-more = More filters
review-queue-tab = Queue
statistics-lead = Errors against manufacturers’ heights, and distributions of measured heights.
statistics-loading = the statistics
statistics-by-size = { $count ->
    [one] 1 roof has no reference height because its model was chosen by its sizes.
   *[other] { NUMBER($count) } roofs have no reference height because their models were chosen by their sizes.
}
statistics-counted = { $measurements ->
    [one] { $measurements } measurement
   *[other] { $measurements } measurements
} of { $vehicles ->
    [one] { $vehicles } vehicle
   *[other] { $vehicles } vehicles
}, { $roofs ->
    [one] { $roofs } roof
   *[other] { $roofs } roofs
} with a manufacturer’s height.
statistics-without-time = { $count ->
    [one] { NUMBER($count) } vehicle is excluded because the start of its recording is not confirmed. <link>Confirm it in Recordings</link>
   *[other] { NUMBER($count) } vehicles are excluded because the starts of their recordings are not confirmed. <link>Confirm them in Recordings</link>
}
statistics-without-class = { $count ->
    [one] { NUMBER($count) } vehicle has no class and is excluded from results by class. <link>Choose it in Measure</link> (list: No class).
   *[other] { NUMBER($count) } vehicles have no class and are excluded from results by class. <link>Choose them in Measure</link> (list: No class).
}
statistics-left-out = Excluded: { $states }.
statistics-of-scans = { $count ->
    [one] 1 height of line scans is counted under Motion.
   *[other] { NUMBER($count) } heights of line scans are counted under Motion.
}
statistics-left-out-state = { $state ->
    [to_review] { NUMBER($count) } to review
    [reopened] { NUMBER($count) } reopened
    [rejected] { NUMBER($count) } rejected
    [accepted] { NUMBER($count) } accepted
    [out_of_sample] { NUMBER($count) } outside the sample
   *[fixed] { NUMBER($count) } fixed
}
statistics-none-accepted-title = No accepted measurements yet
statistics-none-title = No measurements here
statistics-to-review = Go to Review
statistics-show-to-review = Include unreviewed
statistics-to-measure = Measure vehicles
statistics-none-accepted = { $count ->
    [one] Only accepted measurements count, and { NUMBER($count) } measurement waits for review.
   *[other] Only accepted measurements count, and { NUMBER($count) } measurements wait for review.
}
statistics-none-filtered = No measurements match the filter. Clear or change it.
statistics-none = Measure vehicles and have them reviewed; their figures then appear here.
statistics-taillight = Taillight, lower edge

## Statistics: the filter

statistics-filter = Filter
statistics-filter-state = Review state
statistics-filter-state-all = all
statistics-filter-target = Target
statistics-filter-target-all = all
statistics-filter-lighting = Lighting
statistics-filter-any = any
statistics-filter-operator = Operator
statistics-filter-anybody = any
statistics-filter-filmed_from = Filmed from
statistics-filter-filmed_to = Filmed to
statistics-filter-hour_from = From hour
statistics-filter-hour_to = To hour
statistics-filter-over-midnight = Past midnight: each night belongs to the day on which it begins.
statistics-filter-first-day = Measured from (UTC)
statistics-filter-last-day = Measured to (UTC)
statistics-filter-correction = Correction
statistics-correction-inset = inset (default)
statistics-correction-shift = mean error (Dupuis et al.)
statistics-correction-none = none (inset 0)
statistics-correction-regression = regression
statistics-correction-deconvolution = deconvolution
statistics-filter-rounding = Error table
statistics-rounding-cm = whole cm (Dupuis et al.)
statistics-rounding-none = not rounded
statistics-filter-surveys = Surveys
statistics-filter-surveys-some = { $count ->
    [one] { NUMBER($count) } survey
   *[other] { NUMBER($count) } surveys
}
statistics-filter-surveys-none = all surveys
statistics-filter-surveys-help = Surveys to include. None selected: all.
statistics-reference-u = u of a reference height
statistics-reference-u-hint = For heights without a u of their own. Uniform distribution, half-width { $limit }
statistics-reference-u-inches = Enter a number of inches.
statistics-reference-u-millimetres = Enter a number of millimetres.

## Statistics: the error table

stat-trend-needs = A trend needs at least { $least } vehicles; { stat-there-are }.
stat-heights-alike = All heights are the same, so there is no trend.
stat-limits-need = Limits of agreement need at least { $least } vehicles; { stat-there-are }.
stat-variance-shares-need = Shares of the variance need at least { $least } vehicles; { stat-there-are }.
stat-errors-alike = All errors are the same; nothing can be said of their spread.
stat-errors-of-one-size = All errors are of the same size, so there is no trend.
stat-errors-without-interval = all errors are the same, so bias, MAE, RMSE and SD have no interval
stat-reference-explains-all = The reference heights’ own uncertainty explains all of the errors’ variance: nothing remains for the measurement.
stat-reference-explains = The reference heights’ own uncertainty explains { $share } % of the errors’ variance; { SMALL($camera_sd_m, digits: 0) } remain for the measurement.
stat-shifted = The mean signed error of { NUMBER($count) } vehicles of known height, { SMALL($mean_m, digits: 1) }, was subtracted from every height (as in Dupuis et al.).
stat-by-inset = Each height is corrected by the inset of its measurement; no other correction is made.
stat-correction-needs = This correction needs at least { $least } vehicles with a reference height; { stat-there-are }.
stat-known-alike = The vehicles of known height are all of one height, so their error has no trend with it.
stat-variance-unknown = The reference heights alone explain the errors’ variance, so the variance of the measurement is unknown and cannot be removed.
stat-variance-needs = A variance needs at least 2 heights.
stat-variance-too-large = The variance of the measurement is larger than that of the heights, so it cannot be removed.
stat-uncorrected = Heights as in Dupuis et al. (inset 0), without a correction.
stat-deconvolved = After the shift by { SMALL($mean_m, digits: 1) }, the measurement’s own standard deviation of { SMALL($camera_sd_m, digits: 1) } was removed: every height moved towards the mean by { $keep } %.
stat-percentile-needs = P{ $percent } needs { NUMBER($needed) }; { stat-there-are }
stat-percentile-needs-alike = P{ $percent } needs { NUMBER($needed) }; { stat-there-are }, equivalent to { NUMBER($like) } of equal weight
stat-density-needs = A density needs at least { $least } vehicles; { stat-there-are }.
stat-values-alike = All values are the same; a density needs values that differ.
stat-no-reference = no counted height of this group has a reference height
stat-none-of-class = no accepted heights of its class
stat-vehicles-give = { NUMBER($vehicles) } vehicles give percentile { $percent } a 95 % interval about { SMALL($width_m, digits: 0) } wide, for normally distributed heights with a standard deviation of { SMALL($sd_m, digits: 0) }.
stat-heights-needed = needs { NUMBER($needed) } heights; { stat-there-are }
stat-sites = differences between { $sites } sites
stat-shared-errors = errors that heights share
stat-random-error-removed = random error (removed from the values)
stat-random-errors = random errors of heights
stat-known-heights = errors of the known heights (both left in the values)
stat-known-without-u = no known height has an uncertainty to be compared with
stat-known-u-is-corrected = the stated uncertainties are of heights corrected by their inset
stat-true-heights-alike = the heights are all the same
stat-heights-closer-than-errors = the heights lie closer together than their uncertainties allow
stat-sampling = sampling
stat-alone = { $part } alone
stat-too-few-errors = too few different errors for a bootstrap interval
stat-no-value = No vehicle has this value.
stat-group-empty = no vehicle in this group
stat-regressed = The error’s regression on the measured height of { NUMBER($count) } vehicles ({ SMALL($intercept_m, digits: 1) } at height 0 and { $slope } mm more per m) was subtracted from every height.
stat-extrapolated = { $outside } % of the heights lie outside the { NUMBER($low_m, minimumFractionDigits: 2) } to { NUMBER($high_m, minimumFractionDigits: 2) } m of the regression; the correction extrapolates there and is not reliable.
stat-there-are = { $count ->
    [0] there is none
    [one] there is { NUMBER($count) }
   *[other] there are { NUMBER($count) }
}
stat-too-few = { $count ->
    [one] { NUMBER($count) } vehicle is too few for an interval; { $needed } are needed
   *[other] { NUMBER($count) } vehicles are too few for an interval; { $needed } are needed
}
stat-too-few-of-spread = { $count ->
    [one] { NUMBER($count) } vehicle is too few for an interval of MAE, RMSE and SD; { $needed } are needed
   *[other] { NUMBER($count) } vehicles are too few for an interval of MAE, RMSE and SD; { $needed } are needed
}
stat-holding-sites = { $parts }; they apply to roads like those of these sites
stat-holding-unlike-sites = { $parts }; they apply to roads like those of these sites, which differ by more than half of what their vehicles do: intervals of percentiles far from the median hold the truth less often than 95 % then; measure at more sites, or compare sites of one kind
stat-holding-place = { $parts }; they apply to the site of the survey only
stat-errors-of = { $heights ->
    [inset] Heights corrected by each measurement’s inset
   *[paper] Heights as in Dupuis et al. (inset 0)
} against manufacturers’ heights, { $rounded ->
    [cm] both rounded to whole centimetres, as in Dupuis et al.
   *[none] not rounded
}; all values from the individual errors.
statistics-errors-title = Error against manufacturers’ heights
statistics-errors-save = Error table as CSV
statistics-errors-head = Error = measured − reference
statistics-error-bias_m = Bias
statistics-error-mae_m = MAE
statistics-error-rmse_m = RMSE
statistics-error-mse_m2 = MSE
statistics-error-sd_m = SD
statistics-error-pearson_error_vs_height = r(error, height)
statistics-error-pearson_abs_error_vs_height = r(|error|, height)
statistics-errors-note = Below each value: its 95 % CI. SD is that of the signed error, n − 1. Values are not pooled from other values.
statistics-errors-holds = The intervals include { $words }. Those of correlations, skewness and regression lines include sampling only.
statistics-shares-title = Shares of errors in per cent, with 95 % CIs, and skewness
statistics-skewness = Skewness
statistics-within = Within { $within }
paper-day = SD is that of the signed error and differs from the RMSE, so there was a bias of 7 to 13 mm that is not printed. The text’s “less than 10 % below 2 cm” is possible here: MAE and MSE allow as little as 0 to 3 % where errors reach 7 cm.
paper-low-light = Perfect clicks (within 1 px, reference heights within 3 cm) already give MAE 0.016 m and RMSE 0.019 m: this column shows the limit of the reference, not of the method. The printed SD of 0.059 ft should be 0.062 ft. “Less than 10 % below 2 cm” is impossible here: MAE and MSE allow no less than 26.5 %.
paper-overall = Not the pooled values of the 400 and 250 vehicles, which are MAE 0.0198 m and RMSE 0.0249 m. The abstract’s “MAE < 1.8 cm” is not in the table; the MSE in feet has a wrong factor and exponent. “Less than 10 % below 2 cm” needs an error of more than 10 cm here.
paper-sizes = Printed sizes are 3.1 to 9.1 % longer than the true lengths (5.6 % in the mean); the text attributes this to shadows, although it states less than 1 %. Braking “within 1 %” differs by up to 1.5 % from the other runs of the same car. Speed was compared with the car’s own speedometer only, not with a reference.
statistics-paper-inconsistent = Inconsistencies in Table 1 of Dupuis et al.
statistics-paper-note = <strong>{ $group }:</strong> { $note }
statistics-paper-printed = Dupuis et al., as printed
statistics-stands-for = corresponds to { $group }
statistics-no-interval = { $figures }: { $reason }
statistics-reference-part = This alone causes a correlation of { $correlation } between error and height, independent of the camera (reference u = { $u_reference }).
statistics-bland-altman = Bland and Altman: limits of agreement { $lower } ({ $lower_interval }) and { $upper } { $unit } ({ $upper_interval }), n = { $n }.

## Samples: files to try with

samples-pictures = To try: { NUMBER($count) } laboratory images as a ZIP (unpack it; the board has { $columns } × { $rows } inner corners, squares of { $square })
samples-clip = To try: the demonstration’s clip
samples-catalogue = To try: a catalogue of invented models

## Statistics: errors against known heights, by target

statistics-known-title = Errors by target
statistics-known-help = Measured minus known height, for accepted heights with a known value (the manufacturer’s or a taped one). Heights are not rounded. Intervals are total; hold the pointer over one to see what it includes. A model chosen by its sizes is not used as a reference. Check targets have their own rows and are excluded from distributions.
statistics-known-target = Target
statistics-known-check = { $target }, check targets
statistics-known-holds = Includes { $words }.
statistics-known-inside = Within their U95
statistics-known-inside-of = { $inside } of { $n }
statistics-known-none = No known heights yet. Enter manufacturers’ heights, lamp heights or a check target in the vehicle records.

## Statistics: the figures of the error

statistics-group-daytime = Daytime
statistics-group-low_light = Low light
statistics-group-overall = Overall
statistics-group-unknown = Lighting unknown
statistics-group-n = { $group } n = { $n }
statistics-nothing = Nothing to draw.
statistics-nothing-because = Nothing to draw: { $reason }
statistics-absolute-title = Absolute error, cumulative
statistics-absolute-says = Cumulative share of vehicles by absolute error; { $groups }
statistics-absolute-note = Simultaneous 95 % confidence bands (DKW) for 30 vehicles or more; they include sampling only. { $groups }.
statistics-absolute-x = Absolute error ({ $unit })
statistics-relative-title = Relative error, cumulative
statistics-relative-says = Cumulative share of vehicles by error in per cent of their height; { $groups }
statistics-relative-note = Absolute error divided by the reference height. { $groups }.
statistics-relative-x = Relative error (%)
statistics-density-title = Signed error, density
statistics-density-says = Density of the signed error; { $groups }
statistics-density-note = Gaussian kernel, bandwidth { $bandwidths }; pointwise 95 % band (sampling only) for 30 vehicles or more. { $groups }.
statistics-density-note-rounded = Gaussian kernel, bandwidth { $bandwidths }, at least half of the { $rounding } of rounding; pointwise 95 % band (sampling only) for 30 vehicles or more. { $groups }.
statistics-signed-error = Signed error ({ $unit })
statistics-density-y = Share of vehicles (% per { $unit })
statistics-trend-title = Error against manufacturer’s height
statistics-trend-says = Signed error over the manufacturer’s height of { $count ->
    [one] { NUMBER($count) } vehicle
   *[other] { NUMBER($count) } vehicles
}.
statistics-trend-nothing = Nothing to draw: no vehicle has a reference height.
statistics-trend-x = Manufacturer’s height ({ $unit })
statistics-trend-legend = Regression, 95 % band
statistics-trend = Slope { $slope } { $small } per { $unit } ({ $slope_interval }), r = { $correlation }.
statistics-trend-absolute = Absolute error: r = { $correlation }.

## Statistics: one target

statistics-heights = { $count ->
    [one] { NUMBER($count) } height
   *[other] { NUMBER($count) } heights
}
statistics-heights-mean = { $count ->
    [one] { NUMBER($count) } height, corrected mean { $mean }
   *[other] { NUMBER($count) } heights, corrected mean { $mean }
}
statistics-heights-mean-sd = { $count ->
    [one] { NUMBER($count) } height, corrected mean { $mean }, SD { $sd }
   *[other] { NUMBER($count) } heights, corrected mean { $mean }, SD { $sd }
}
statistics-curve-raw = uncorrected
statistics-curve-corrected = corrected
statistics-legend-raw = uncorrected (inset = 0)
statistics-target-ecdf-title = { $target }, cumulative
statistics-target-ecdf-says = Cumulative distribution of { $target } heights, uncorrected and corrected, { $count ->
    [one] { NUMBER($count) } vehicle
   *[other] { NUMBER($count) } vehicles
}
statistics-target-ecdf-note = Band: 95 %, simultaneous (DKW), sampling only.
statistics-target-ecdf-away = { $count ->
    [one] { NUMBER($count) } standard off scale.
   *[other] { NUMBER($count) } standards off scale.
}
statistics-target-nothing = Nothing to draw: no heights of this target match the filter.
statistics-height-x = Height above the road ({ $unit })
statistics-target-density-title = { $target }, density
statistics-target-density-says = Density of corrected { $target } heights
statistics-target-density-note = Corrected heights, Gaussian kernel, pointwise 95 % band (sampling only) for 30 vehicles or more.
statistics-share = { $standard }, { $height }: <strong>{ $share }</strong> of { $target ->
    [driver_eye] drivers’ eyes
    [taillight] taillights
    [headlight] headlights
   *[other] heights
} are below <muted>({ $low } to { $high }; measured heights: { NUMBER($below) } of { NUMBER($n) })</muted>
statistics-compared-title = { $second } compared with { $first }
statistics-compared-figure = Figure
statistics-compared-mean = Mean
statistics-compared-heights = Heights
statistics-compared-of = { NUMBER($first) } and { NUMBER($second) }
statistics-compared-difference = Difference
statistics-compared-verdict = Verdict
statistics-compared-higher = higher (significant)
statistics-compared-lower = lower (significant)
statistics-compared-alike = no significant difference
statistics-compared-unknown = no interval: { $reason }
statistics-compared-none = No target has at least two heights in both surveys.
statistics-compared-note = Differences of true heights, later survey minus earlier survey, with total 95 % intervals. A difference is called higher or lower if its interval excludes 0. Errors are taken as independent between the surveys; where surveys share errors, the intervals are too wide, never too narrow.
statistics-rule-title = Standards: the same percentile today
statistics-rule-standard = Standard
statistics-rule-rule = Rule
statistics-rule-of = { $what }: P{ $percent } of { $class }
statistics-rule-whose = { $whose ->
    [cars] passenger cars
    [trucks] lorries and tractor units
   *[all] all vehicles, as no class is known
  }{ $chosen ->
    [yes] { " " }of the chosen classes
   *[no] { "" }
  }
statistics-rule-read = here: { $whose }, n = { $n }
statistics-rule-height = Standard ({ $unit })
statistics-rule-today = Today ({ $unit })
statistics-rule-interval = { $low } to { $high }
statistics-rule-difference = Difference
statistics-rule-verdict = Verdict
statistics-rule-lower = lower (risk of error { $risk })
statistics-rule-higher = higher (risk of error { $risk })
statistics-rule-least = less than { $risk }
statistics-rule-alike = undecided; lower with a probability of { $lower }
statistics-rule-unknown = no verdict: { $reason }
statistics-rule-none = No verdict on any standard yet: a percentile has an interval only with enough accepted heights. The last column states how many vehicles each one needs.
statistics-rule-note = The percentile on which a standard is based, for today’s true heights, with its total 95 % interval. “Lower” or “higher” is stated if the risk of error is at most 2.5 % (JCGM 106).
statistics-percentiles = Percentiles, { $target }
statistics-percentiles-save = Percentiles as CSV
statistics-percentile = Percentile
statistics-percentiles-corrected = Corrected ({ $unit })
statistics-percentiles-raw = Uncorrected ({ $unit })
statistics-percentiles-true = True heights ({ $unit })
statistics-percentiles-total = True heights: random measurement error is removed from the spread. Their 95 % intervals include { $words }.
statistics-percentiles-note = The other 95 % intervals cover sampling only.
statistics-percentiles-without = { $count ->
    [one] Why { NUMBER($count) } percentile has no interval
   *[other] Why { NUMBER($count) } percentiles have no interval
}
statistics-percentiles-reason = { $percentiles }: { $reason }.

## Statistics: heights by group

statistics-lateral-title = Lateral position
statistics-lateral-note = Distance of the tyre contact from the camera, measured across the road; one value per vehicle, the median of its contacts. A lane is all traffic that travels one way in the frame.
statistics-lateral-figure = Lateral position by lane
statistics-lateral-says = Cumulative distributions of the distance from the camera across the road, of { NUMBER($count) } lanes.
statistics-lateral-x = Distance from the camera across the road ({ $unit })
statistics-lateral-none = No vehicle has a direction yet, so there are no lanes. The pass search sets it; you can also set it in the vehicle record.
statistics-lateral-vehicles = Vehicles
statistics-lateral-all = all
statistics-lane-right = To the right
statistics-lane-left = To the left
statistics-groups-title = Corrected heights by group
statistics-groups-target = Target
statistics-groups-by = Grouped by
statistics-grouping-category = Category
statistics-grouping-class_set = Set
statistics-grouping-lighting = Lighting
statistics-grouping-site = Site
statistics-grouping-operator = Operator
statistics-groups-head = { $grouping ->
    [category] Category
    [class_set] Set of classes
    [lighting] Lighting
    [site] Site
   *[operator] Operator
}
statistics-groups-figure = { $grouping ->
    [category] { $target } by category
    [class_set] { $target } by set of classes
    [lighting] { $target } by lighting
    [site] { $target } by site
   *[operator] { $target } by operator
}
statistics-groups-says = Cumulative distributions of { $target } heights by { $grouping ->
    [category] category
    [class_set] set of classes
    [lighting] lighting
    [site] site
   *[operator] operator
}, { $count ->
    [one] { NUMBER($count) } group
   *[other] { NUMBER($count) } groups
}
statistics-groups-note = The { NUMBER($count) } largest of { NUMBER($all) } groups; the table lists { NUMBER($listed) }.
statistics-groups-nothing = { $grouping ->
    [category] Nothing to draw: no vehicle has a category.
    [class_set] Nothing to draw: no vehicle is in a set.
    [lighting] Nothing to draw: no vehicle has its lighting set.
    [site] Nothing to draw: no vehicle has a site.
   *[operator] Nothing to draw: no vehicle has an operator.
}
statistics-groups-mean = Mean ({ $unit })
statistics-groups-sd = SD ({ $unit })

## Statistics: standards

statistics-standards-title = Design standards shown
statistics-standards-change = Change this survey’s standards
statistics-standards-one-survey = The table belongs to the survey and goes into its package.
statistics-standards-surveys = Each survey has its own table; choose one survey to change it.
statistics-standards-address = Your selection is saved in the link.
statistics-standards-loading = the standards
statistics-standard-of-eye_car = eye, passenger cars
statistics-standard-of-eye_truck = eye, trucks
statistics-standard-of-object_stopping = object, stopping
statistics-standard-of-object_passing = object, passing
statistics-standard-of-headlight = headlight (sags)
statistics-standard-of-vehicle = vehicle
statistics-standard-percentile = P{ $percent }
statistics-standard-rule = P{ $percent } of { $group }
statistics-standard-edition = { $source }, { $edition }
statistics-standard-cited = Quoted from { $by }; the text itself was not consulted. Check it before use.
statistics-standard-edition-field = Edition
statistics-standard-year = Year
statistics-standard-class = Vehicle class of the percentile
statistics-standard-cited-by = Quoted from
statistics-standard-drawn-yes = yes
statistics-standard-drawn-no = no
statistics-standards-rule = Rule
statistics-standards-drawn = Shown
statistics-standards-standard = Standard
statistics-standards-for = For
statistics-standards-height = Height
statistics-standards-source = Source
statistics-standards-remove = Remove
statistics-standard-draw = Show { $standard }, { $what }, { $height }
statistics-standard-remove = Remove { $standard }
statistics-standard-own-problem = Enter a height above 0 and below 10 m, for example { $example }.
statistics-standard-own = Own value for
statistics-standard-height = Height
statistics-standard-name = Standard
statistics-standard-for = For
statistics-standard-source = Source
statistics-standard-new = New standard
statistics-standard-new-remove = Remove the new standard
statistics-standard-problem = Enter the height of { $standard }, for example { $example }.
statistics-standard-new-problem = Enter the height of the new standard, for example { $example }.
statistics-standards-add = Add a standard
statistics-standards-save = Save for this survey

## Statistics: how many vehicles to measure

statistics-plan-title = How many vehicles to measure
statistics-plan-percentile = Percentile
statistics-plan-width = Width of its 95 % interval
statistics-plan-sd = Spread of heights (SD)
statistics-plan-incomplete = Enter three numbers.

## Planning: the page

planning-lead-heights = Estimate the uncertainty of heights at this site before you record.
planning-lead-lines = Estimate the uncertainty of speeds from two line-scan cameras before you record.
planning-nothing-stored = Nothing is saved. To share this plan, copy the page address.
planning-what = What to plan
planning-what-heights = Heights (video)
planning-what-lines = Speeds (line scan)
planning-loading-cameras = the cameras
planning-loading-rig = the survey’s rig
planning-loading = the plan
plan-board-square = Set the board perpendicular to the road, not plumb: on a crossfall of { $crossfall } % a plumb board biases heights by { SMALL($here_m, digits: 0) } at { $distance_m } m and by { SMALL($further_m, digits: 0) } at 1 m more.
plan-out-of-sight = Road or target is outside the image for: { $targets }; move the camera back or use a wider lens.
plan-oblique = A board seen obliquely determines the camera’s direction better than one seen frontally, while clicks are slightly less precise: with the camera turned 30 degrees along the road, the U95 of an eye is { SMALL($U95_turned_m, digits: 0) } instead of { SMALL($U95_square_m, digits: 0) }.
plan-second-frame = Click eye and contact in a second frame where possible: with { $travel_m } m of travel the inset is computed instead of assumed, and U95 falls from { SMALL($U95_one_m, digits: 0) } to { SMALL($U95_two_m, digits: 0) }. At 50 km/h and 25 frames/s, this is { $frames } frames later.
plan-board-at-wheel-path = Put the board at the wheel path, { $distance_m } m away, not at { $board_m } m: errors of pose, tilt and focal length vanish at the board’s distance and grow away from it.
plan-lane-close = The lane is very close; move the camera back to at least 2 m.
plan-board-unseen = The image would not show a board at { $board_m } m with its top row { $board_top_m } m above the road; put it at the wheel path, move the camera back, or use a wider lens.
plan-camera-at-eye = The camera is at about the height of a driver’s eye ({ $height_m } m), where the inset has little effect; for roofs or lamps, place it at their height.
plan-second-frame-no-gain = A second frame after { $travel_m } m of travel does not reduce the uncertainty here (U95 of an eye: { SMALL($U95_two_m, digits: 0) }); use frames further apart.
plan-camera-height = Put the camera at the height to be measured, where the inset has no effect: { $height_m } m for a driver’s eye. At { $camera_height_m } m, ignoring the inset biases the height by { SMALL($near_m, digits: 0) } for a driver on the near side and { SMALL($far_m, digits: 0) } on the far side.
plan-target = { $target ->
    [driver_eye] driver’s eye
    [driver_eye_far] driver’s eye on the far side
    [taillight] taillight
    [headlight] headlight
    [roof] roof
   *[other] other
}
plan-lines-expected = Expected of the default method, from simulated vehicles that fill the image; little texture, strong noise or rain make it worse, and each vehicle’s own uncertainty states what was reached.
plan-lines-few = Only { $lines } lines lie between the cameras; use a higher line rate or a longer baseline, otherwise this vehicle can hardly be measured.
plan-lines-coarse = The vehicle moves { SMALL($line_m, digits: 1) } from line to line; beyond { SMALL($coarse_m, digits: 0) } most vehicles are refused. Use { $rate_hz } Hz or more.
plan-lines-apart = The vehicle moves { SMALL($line_m, digits: 1) } from line to line, which can be measured; { $rate_hz } Hz brings it to { SMALL($good_m, digits: 0) }.
plan-lines-U95 = The speed’s U95 is { $reached } %, more than the { $allowed } % allowed; use a baseline { $times } times as long, measured as accurately.
plan-lines-baseline-exact = The baseline is taken as exact; enter its uncertainty, which is part of every speed.
plan-lines-baseline-limits = The baseline is the limit, not the line rate: its standard uncertainty is { $baseline } %, registering the strips adds { $strips } %. Measure the baseline more accurately first.
plan-lines-strips-limit = Registering the strips is the limit, not the baseline: registering adds { $strips } % (standard uncertainty), the baseline { $baseline } %. Use a longer baseline.
plan-lines-no-share = The error must be a share between 0 and 1; speed and baseline greater than 0.
plan-lines-above-zero = Speed, baseline and line rate must be greater than 0.
plan-lines-vehicle = The vehicle must be up to 100 m long, the gap up to 3600 s; both greater than 0.
plan-lines-u-baseline = The baseline’s uncertainty must be at least 0 and less than the baseline.
planning-advice = Advice
planning-lens-exact = Assumes no calibration uncertainty.
planning-lens-exact-plain = Assumes an ideal lens: no distortion, no calibration uncertainty.
planning-lens-calibrated = A real calibration adds uncertainty, mostly away from the board.
planning-target-roof = Roof
planning-target-driver_eye = Driver’s eye, near side
planning-target-driver_eye_far = Driver’s eye, far side
planning-target-taillight = Taillight
planning-target-headlight = Headlight

## Planning: what is planned with

planning-picture-width_px = Image width
planning-picture-height_px = Image height
planning-picture-field_of_view_deg = Horizontal field of view
planning-camera-height = Camera above road
planning-distance = Distance to wheel path
planning-board-distance = Distance to board
planning-usual-board_distance_m = wheel path
planning-direction = Yaw from perpendicular
planning-sigma = Click uncertainty (u)
planning-travel = Travel between frames
planning-camera = Camera
planning-calibration = { $camera }, calibration { $id } of { $day }
planning-calibration-in-use = { $camera }, calibration { $id } of { $day } (current)
planning-calibration-unknown = calibration { $id }
planning-camera-plain = A camera without a calibration
planning-number-problem = Enter a number.
planning-lines-speed_mps = Fastest vehicle
planning-lines-error = Allowed speed error (U95)
planning-lines-baseline_m = Baseline
planning-lines-u_baseline_m = u of the baseline
planning-lines-line_rate_hz = Camera’s line rate
planning-usual-line_rate_hz = 10 mm a line
planning-lines-length_m = Vehicle length
planning-lines-time_gap_s = Time gap
planning-lines-pixel_width_um = Pixel width
planning-lines-pixel_height_um = Pixel height
planning-lines-focal_mm = Focal length
planning-lines-distance_m = Distance
planning-lines-exposure_us = Exposure
planning-usual-exposure_us = the whole line
unit-um = µm
unit-us = µs
unit-mm = mm

## Planning: the table of targets

planning-targets-title = Expected uncertainty by target
planning-target = Target
planning-planned-height = Planned height
planning-inset = Inset
planning-two-frames = U95, two frames
planning-inset-ignored = Bias if inset is ignored
planning-targets-note = Heights are typical values; insets are those of the survey. Two frames: the vehicle has moved { $travel } between them, and the inset is computed instead of assumed.
planning-parts-title = Uncertainty budget, one frame
planning-parts-label = Uncertainty budget
planning-parts-source = Source
planning-parts-sum = Combined standard uncertainty u

## Planning: exposure and frames of a pass

planning-passing-title = Exposure and frames of a pass
planning-passing-speed = Speed
planning-passing-exposure = Longest exposure
planning-passing-blur = Blur at 1/1000 s
planning-passing-frames-30 = Frames at 30/s
planning-passing-frames-60 = Frames at 60/s
planning-passing-note = Longest exposure: the vehicle moves 2 px in the middle of the frame. More motion blur makes clicks less precise. Frames: those that show the road and a driver’s eye; two are needed, ten are good for following a whole pass.
planning-passing-px = { $blur } px
planning-passing-fraction = 1/{ $part } s
no-such-language = There is no report in the language “{ $language }”. Choose one of { $known }.
planning-no-language = There is no sheet in the language “{ $language }”. Choose one of { $known }.
planning-sheet = Set-up sheet (PDF)

## The set-up sheet: one page to take along

sheet-title = Set-up sheet
sheet-of = { $survey } · { $site }
sheet-lead = From Sightline’s site planning, drawn to scale. Heights depend on the values measured on the day: enter them in the last column.
sheet-planned = Planned
sheet-built = On the day
sheet-camera-plain = Not calibrated yet, { NUMBER($degrees, maximumFractionDigits: 1) }° wide
sheet-camera-value = { $name }, { $width_px } × { $height_px } px
sheet-metres = { NUMBER($metres, minimumFractionDigits: 2, maximumFractionDigits: 2) } m
sheet-metres-in-words = { $what }: { sheet-metres }
sheet-degrees = { NUMBER($degrees, maximumFractionDigits: 1) }°
sheet-millimetres = { NUMBER($millimetres, minimumFractionDigits: 1, maximumFractionDigits: 1) } mm
sheet-kmh = { NUMBER($kmh, maximumFractionDigits: 0) } km/h
sheet-blur = { NUMBER($pixels, minimumFractionDigits: 1, maximumFractionDigits: 1) } px
sheet-none = not measurable
sheet-row = Board’s reference row above the road (taped twice)
sheet-zoom = Zoom and focus (taped)
sheet-exposure = Exposure, gain, white balance (fixed)
sheet-start = Start of the recording, time zone
sheet-traffic = Traffic keeps; steering wheel; camera on verge or median
sheet-weather = Weather, street lighting, speed limit
sheet-checks = Check list
sheet-check-calibrated = Camera calibrated at this zoom and focus; both taped
sheet-check-board = Square measured across ten squares; board flat against a straight edge
sheet-check-place = Straight, even road; tyre contacts in the image; tripod weighted
sheet-check-exposure = Exposure, gain, focus and white balance fixed; blur below 2 px
sheet-check-stood = Board at the wheel path, perpendicular to the road, its rows along the traffic
sheet-check-row = Reference row taped twice, to a millimetre
sheet-check-filmed = Board filmed at rest for five seconds, then at another distance
sheet-check-watch = A watch filmed, or the start written down
sheet-check-own = A vehicle of known heights driven past
sheet-check-again = Board filmed again at the end, and whenever the camera was touched

## Planning: figures and drawings

planning-figure-distance-title = Expanded uncertainty (95 %) by distance
planning-figure-distance-note = Single frame, planned set-up. Lines end at the edge of the field of view.
planning-figure-distance-label = U95 of vehicles at other distances, U95 in { $small } over distance across the road to the wheel path in { $unit }
planning-figure-distance-x = Distance to the wheel path ({ $unit })
planning-figure-distance-y = U95 ({ $unit })
planning-figure-bias-title = Bias of a driver’s eye if its inset is ignored
planning-figure-bias-note = Zero when the camera is at eye height.
planning-figure-bias-label = Error of a driver’s eye whose inset is ignored, error in { $small } over camera above the road in { $unit }
planning-figure-bias-x = Camera above the road ({ $unit })
planning-figure-bias-y = Error ({ $unit })
planning-figure-bar = The bar marks the planned place.
planning-along-title = The site, seen along the road
planning-along-note = To scale. The wedge is the vertical field of view; dots are the targets.
planning-along-label = Cross-section: camera { $camera_height } above the road, board at { $board_distance }, wheel path at { $distance }
planning-above-title = The site from above
planning-above-note = To scale. The frame shows { $shown } of the wheel path with road and a driver’s eye in it.
planning-above-label = From above: the camera looks across the road, square to it, a car in the lane
planning-above-label-turned = { $turned_deg ->
    [one] From above: the camera looks across the road, turned { $turned_deg } degree along the road, a car in the lane
   *[other] From above: the camera looks across the road, turned { $turned_deg } degrees along the road, a car in the lane
}
planning-wheel-track = wheel path { $distance }
planning-wheel-track-and-board = wheel path and board { $distance }
planning-board = board { $distance }

## Planning: the line rate

planning-speed-title = Expected uncertainty of speed
planning-lines = At { $speed } a vehicle takes <strong>{ $lines } lines</strong> from camera 1 to camera 2 at { $line_rate_hz } lines/s; one line is { $one_line } of road.
planning-speed-u = Standard uncertainty: { $u_strips } from registering the strips, { $u_baseline } from the baseline. Result: <strong>{ $speed }</strong> (95 %).
planning-values-title = Expected uncertainties
planning-values-note = for a vehicle at this speed behind another at the same speed, measured by the default method
planning-values-quantity = Quantity
planning-values-value = Value and U95
planning-values-strips = u from the strips
planning-values-baseline = u from the baseline
planning-values-edges = u from front and rear
planning-values-speed = Speed
planning-values-length = Length
planning-values-time_gap = Time gap
planning-values-distance_gap = Distance gap
planning-ms = { $value } ms
planning-exposure-title = Pixels and exposure
planning-exposure-blur = With an exposure of { $exposure_us } µs, each line is blurred by <strong>{ $blur }</strong> of road; the vehicle travels { $line } from line to line. A pixel covers { $width } along the road and { $height } vertically, so a vertical edge is spread over <strong>{ $smear }</strong>.
planning-exposure-shape = A pixel is <strong>{ $shape }</strong> times as high as the line spacing. One row of misalignment changes the speed by up to { $row_error } where an edge is inclined by 45°.
planning-exposure-light = A line receives <strong>{ $light }</strong> times the light of a 5 µm × 5 µm pixel exposed for 1 ms at the same aperture.
planning-exposure-dark = Low light: open the aperture, use larger pixels or binning, or lower the line rate.
planning-exposure-wide = Pixels are wider than two line spacings: a higher line rate adds little. Use a longer focal length.
planning-exposure-tall = Pixels are much higher than the line spacing: align both cameras to a fraction of a row, or use more rows.
planning-exposure-too-long = An exposure of { $exposure_us } µs is longer than one line, { $line_us } µs. Enter a shorter exposure or a lower line rate.
planning-camera-cannot-be = { $name } of { $value } is out of range. Enter a value above 0 and up to { $most }.
planning-forms-title = Equation (2) of Douxchamps et al., as printed and as corrected
planning-forms-label = Both forms of equation (2)
planning-forms-equation = Equation (2)
planning-forms-printed = As printed: its right side
planning-forms-corrected = Corrected: its middle term
planning-forms-error = Speed error
planning-forms-says = Note
planning-forms-says-printed = n + 2 lines are counted instead of n, divided by n + 2. The printed 6600 Hz follow from it; the printed 1.3 % fit both forms.
planning-forms-says-corrected = n + 2 lines are counted instead of n, divided by n, as in the middle term 2 s / (b f). Slightly more conservative.
planning-forms-line-rate = Line rate for { $error }
planning-forms-line-rate-value = { $line_rate_hz } Hz
planning-forms-error-at = Error at { $line_rate_hz } Hz
planning-forms-error-value = { $error }, { $speed }
planning-forms-note = n = b f / s: number of lines from camera 1 to camera 2, with baseline b, line rate f and speed s. Equation (2) is the worst case for crossings read to whole lines. Sightline registers the strips to fractions of a line and does not need these line rates.

## Survey: the overview

survey-loading = the survey
survey-demonstration = demonstration
survey-edit = Edit
settings-lead = Site, traffic, targets, sample, classes, standards and members of this survey.
settings-site = Site, traffic, targets and insets
settings-traffic-unsaid = Traffic is not described yet.
settings-inset = { $inset } (u = { $u })
settings-members = Members
settings-members-lead = People who can see this survey, and their roles.
settings-classes = Vehicle classes
settings-classes-lead = Classes that count as passenger cars, light trucks and heavy vehicles.
settings-standards-open = Open in Results
settings-standards-lead = Design heights shown in the figures.
members-open = Members
members-invite = Invite a new user
members-title = Members of the survey
members-lead = Only members and administrators can see this survey.
members-lead-open = Everyone who signs in can see this survey and acts with the role of their account. Members have the role shown here.
members-open-to-all = Open to everyone who signs in
members-name = Name
members-role = Role here
members-role-of = Role of { $person } in this survey
members-remove = Remove
members-remove-title = Remove { $person } from the survey?
members-remove-body = { $person } can no longer see it. Their work is kept.
members-remove-yourself = You will no longer see this survey.
members-none = No members yet.
members-inactive = deactivated
members-add = Add
members-add-person = Person
members-add-role = Role
members-choose = Choose a person
members-everybody = Everyone with an account is already a member.
members-does-viewer = sees everything, exports packages
members-does-operator = adds recordings, calibrates, measures
members-does-reviewer = everything an operator does, and reviews other people’s work
members-does-manager = everything a reviewer does, and manages members and blind checks
members-admin = An administrator has all rights here, whatever role is chosen.
members-loading = the members
survey-go-camera = Calibrate
survey-go-recordings = Add recordings
survey-go-pose = Compute pose
survey-go-vehicles = Measure
survey-go-review = Review
survey-go-results = Build package
survey-open = Open
survey-statistics = <link>Results</link>: percentiles with their intervals, standards, errors.
survey-traffic = Traffic keeps { $traffic ->
    [right] right
   *[left] left
}, the steering wheel is usually on the { $steering ->
    [right] right
   *[left] left
}, the camera is { $camera ->
    [verge] on the verge
   *[median] in the median
}.
survey-asked = Targets by day: { $daytime }; in low light: { $low_light }.
survey-traffic-unsaid = The traffic side and the camera position are not set. Eye heights are computed when you set them, for existing clicks too.
survey-traffic-say = Set
overview-calibrated = { $count ->
    [one] 1 camera calibrated.
   *[other] { NUMBER($count) } cameras calibrated.
}
overview-calibrate = Calibrate the camera from images of the checkerboard, or import a calibration.
overview-add-camera = Add a camera and calibrate it.
overview-ready = { $all ->
    [one] { NUMBER($count) } of 1 recording ready.
   *[other] { NUMBER($count) } of { NUMBER($all) } recordings ready.
}
overview-confirm = { $count ->
    [one] Confirm lighting and start of 1 recording.
   *[other] Confirm lighting and start of { NUMBER($count) } recordings.
}
overview-not-imported = A recording could not be imported; see its reason and upload another.
overview-importing = Wait until the recording has been imported.
overview-drop-video = Drop the day’s video here.
overview-posed = Every recording has its camera pose.
overview-mark-board = { $count ->
    [one] Mark the frames with the board at rest in 1 recording.
   *[other] Mark the frames with the board at rest in { NUMBER($count) } recordings.
}
overview-mark-board-later = Mark the frames with the board at rest, once a recording is ready.
overview-find-vehicles = Find the vehicles and measure the targets of the survey on each.
overview-measured = { $count ->
    [one] The vehicle is measured or not visible.
   *[other] All { NUMBER($count) } vehicles are measured or not visible.
}
overview-measure = { $count ->
    [one] Measure { NUMBER($left) } of 1 vehicle.
   *[other] Measure { NUMBER($left) } of { NUMBER($count) } vehicles.
}
overview-not-visible = { $count ->
    [one] 1 target not visible.
   *[other] { NUMBER($count) } targets not visible.
}
overview-review = { $count ->
    [one] Review 1 measurement.
   *[other] Review { NUMBER($count) } measurements.
}
overview-review-line-heights = { $count ->
    [one] Review 1 height of line scans.
   *[other] Review { NUMBER($count) } heights of line scans.
}
overview-remeasure = { $count ->
    [one] Remeasure 1 rejected measurement.
   *[other] Remeasure { NUMBER($count) } rejected measurements.
}
overview-remeasure-line-heights = { $count ->
    [one] Remeasure 1 rejected height of line scans.
   *[other] Remeasure { NUMBER($count) } rejected heights of line scans.
}
overview-accepted = Accepted: { $count ->
    [one] 1 measurement
   *[other] { NUMBER($count) } measurements
}, { $scans ->
    [one] 1 height of line scans.
   *[other] { NUMBER($scans) } heights of line scans.
}
overview-reviewed = { $count ->
    [one] 1 measurement reviewed.
   *[other] { NUMBER($count) } measurements reviewed.
}
overview-nothing-to-review = Nothing to review yet.
overview-packages = { $count ->
    [one] 1 package built.
   *[other] { NUMBER($count) } packages built.
}
overview-build-package = Build the package of results.
overview-no-scans = None here. Two line cameras at a known baseline give speed, length and gaps.
overview-scans-not-imported = { $count ->
    [one] 1 line scan could not be imported; see the reason and try again.
   *[other] { NUMBER($count) } line scans could not be imported; see the reason and try again.
}
overview-scans-importing = { $count ->
    [one] 1 line scan still being imported.
   *[other] { NUMBER($count) } line scans still being imported.
}
overview-scans-find = { $count ->
    [one] Find the vehicles of 1 line scan.
   *[other] Find the vehicles of { NUMBER($count) } line scans.
}
overview-scans-review = { $count ->
    [one] Review { NUMBER($open) } of 1 vehicle.
   *[other] Review { NUMBER($open) } of { NUMBER($count) } vehicles.
}
overview-scans-review-heights = { $count ->
    [one] Review { NUMBER($open) } of 1 height.
   *[other] Review { NUMBER($open) } of { NUMBER($count) } heights.
}
overview-scans-accepted = { $all ->
    [one] { NUMBER($count) } of 1 detected vehicle accepted.
   *[other] { NUMBER($count) } of { NUMBER($all) } detected vehicles accepted.
}
overview-scans-not-measurable = { NUMBER($count) } cannot be measured; see their reasons.
overview-line-heights-accepted = { $all ->
    [one] { NUMBER($count) } of 1 height accepted.
   *[other] { NUMBER($count) } of { NUMBER($all) } heights accepted.
}
survey-scans-none = <link>Line scans</link>: { $summary }
survey-scans-label = Line scans, separate from these steps
survey-scan-results = <link>Motion</link>: speeds, gaps, and lengths compared with the manufacturers’.
survey-count-scans = { $count ->
    [one] line scan
   *[other] line scans
}
survey-count-recordings = { $count ->
    [one] recording
   *[other] recordings
}
survey-count-vehicles = { $count ->
    [one] vehicle
   *[other] vehicles
}
survey-count-measured = of { NUMBER($count) } measured or not visible
survey-count-accepted = { $count ->
   *[other] accepted
}
survey-count-rejected = { $count ->
   *[other] rejected
}
survey-count-scanned-accepted = { $count ->
   *[other] accepted
}
survey-count-measurements = { $count ->
    [one] measurement
   *[other] measurements
}

## Survey: editing it

survey-edit-title = Edit the survey
survey-name = Name
survey-name-problem = Enter a name for the survey.
survey-site = Site
survey-description = Description
survey-insets = Insets
survey-insets-help = Distance of each target behind the plane through the tyres’ outer faces, away from the camera. Used for new measurements; the second value is its standard uncertainty.
survey-insets-target = Target
survey-insets-inset = Inset ({ $unit })
survey-insets-u = u ({ $unit })
survey-inset-label = { $target }: inset in { $unit ->
    [ft] feet
   *[m] metres
}
survey-inset-u-label = { $target }: uncertainty in { $unit ->
    [ft] feet
   *[m] metres
}
survey-inset-problem = { $target }: enter the inset and its uncertainty as numbers in { $unit ->
    [ft] feet
   *[m] metres
}, for example { $inset } and { $u_inset }.

## Survey: photographs of the set-up

photographs-title = Photographs of the set-up
photographs-help = The rig, the road, the board in place. Shown in the report and the package.
photographs-choose = Choose photographs to add
photographs-drop = Drop photographs here, or click to choose
photographs-adding = Adding { NUMBER($count) }…
photographs-hint = JPEG, PNG, WebP or TIFF. Resized to 1600 px; location data removed.
photographs-open = Open { $photograph }
photographs-what = What it shows
photographs-caption = Caption of { $photograph }
photographs-left = Move { $photograph } to the left
photographs-right = Move { $photograph } to the right
photographs-remove = Remove { $photograph }
photographs-removed = { $photograph } removed.

## Surveys: the page

surveys-lead = One survey per site and campaign.
surveys-loading = surveys
surveys-new = New survey
surveys-new-make = Create survey
surveys-new-name = Name
surveys-new-name-example = Rouen south, lane 1
surveys-new-name-problem = Enter a name for the survey, for example the road and the lane.
surveys-new-site = Site
surveys-new-site-example = D938, km 12.4, towards the south
surveys-new-description = Description
surveys-new-description-hint = Notes for anyone who opens this survey later.
surveys-choose-password = Choose a password
surveys-link-used = Set a password so you can sign in again. Your link has been used.
surveys-demo-failed = The demonstration survey could not be created.
surveys-demo-first = The demonstration survey is rendered from a known scene, so every height can be compared with its true value. Try Sightline there first, then create your own survey.
surveys-demo-open = Open the demonstration survey
surveys-demo-title = Demonstration survey
surveys-demo-being-made = being created
surveys-demo-wait = Importing its videos and strips, and computing poses and heights; this may take a minute.
surveys-none-title = No surveys yet
surveys-none-make = Create a survey for a site, calibrate its camera, add the video of the day, and measure. The demonstration survey contains all of that.
surveys-none = No surveys yet. An operator can create the first one.
studies-lead = Surveys of several sites and years combined: heights of the fleet with total uncertainty, and their effect on standards.
studies-loading = the studies
studies-new = New study
studies-new-make = Create study
studies-none-title = No studies
studies-none = A study combines surveys of several sites, weights their vehicles to the fleet, and states the uncertainty of its percentiles.
studies-name = Study
studies-surveys = Surveys
studies-sites = Sites
studies-heights = Heights
studies-computed = Computed
studies-not-computed = not computed
study-loading = the study
study-simulated = simulated
study-none-counts = { $name } has no accepted height that counts; it does not contribute.
study-versions = Packages come from { NUMBER($count) } versions with identical tables: { $versions }.
study-one-site = One site: the intervals apply to that site only.
study-outside-sample = { NUMBER($count) } accepted heights are of vehicles outside their survey’s sample; they do not count.
study-without-class = { NUMBER($count) } heights of { $target ->
    [roof] roofs
    [driver_eye] drivers’ eyes
    [taillight] taillights
    [headlight] headlights
   *[other] other points
} have no class of the fleet; they do not count.
study-sites-unlike = { $target ->
    [roof] Roofs
    [driver_eye] Drivers’ eyes
    [taillight] Taillights
    [headlight] Headlights
   *[other] Other points
}: sites differ by more than half of what their vehicles do. Intervals of percentiles far from the median hold the truth less often than 95 % then; measure at more sites, or put sites of one kind into a stratum.
study-all-simulated = Simulated: no value describes real roads.
study-some-simulated = { NUMBER($count) } of { NUMBER($surveys) } surveys are simulated: no value of this study describes real roads.
study-heights-needed = at least { $least } heights are needed
study-no-weights = no weights meet all shares of the fleet at once
study-one-site-of-stratum = { $stratum } has one site: join it with another stratum, because differences between sites need two
study-class-not-counted = the fleet has { $variable } { $name }, but none of its heights counts
study-class-at-one-site = a stratum has its class at one site only, and differences between sites need two
study-simulated-note = Simulated: nothing was filmed. The vehicles were drawn from known fleets; no value describes real roads.
study-name = Name
study-description = Description
study-report = Report (PDF)
study-package = Study package
study-compute = Compute
study-compute-again = Compute again
study-computed = The study is computed.
study-old-study = The study was changed after these values were computed. Compute it again.
study-old-surveys = Data changed after these values were computed, in { $surveys }. Compute the study again.
study-empty-title = No surveys yet
study-empty = Add the surveys to combine. Each has a site, and may have a stratum and a year.
study-add-surveys = Add surveys
study-not-computed-title = Not computed yet
study-not-computed = Compute the study to see its results.
study-made = Computed { $moment } by { $person } with Sightline { $version }; SHA-256 of the package { $hash }.
study-made-by-system = Sightline
study-joined = Surveys
study-edit = Edit
study-edit-title = Edit study
study-remove = Remove study
study-remove-now = Remove
study-remove-words = { $name } is removed from the list of studies. Its surveys do not change, and its results remain stored.
study-members = Members of this study
study-members-note = Members see the study, its package and its report as long as they see each of its surveys. A person who manages all of these surveys can make the study visible to everyone. Administrators see every study.
study-members-open = Visible to everyone who signs in
study-members-add = Add a member
study-members-choose = Choose a person
study-members-nobody = Everyone is already a member
study-members-remove = Remove { $name }
study-survey = Survey
study-site = Site
study-stratum = Stratum
study-year = Year
study-counted = Heights included
study-outside = Outside the sample
study-weighted = Heights are weighted to the given fleet.
study-not-weighted = No fleet given: vehicles are not weighted.
study-sites-known = Strata, numbers of sites and traffic come from the table of sites.
study-sites-unknown = No table of sites given: each stratum is assumed to have very many sites of equal traffic.
study-goal-is = Planned for a U95 of { $goal } of P10.
study-fleet = Fleet (CSV)
study-fleet-hint = Columns category and share (or registrations); several kinds: variable, class, share. Empty: no weights.
study-sites = Sites (CSV)
study-sites-hint = Columns site and stratum; sites_there and traffic where known. Empty: strata as given with the surveys.
study-goal = Target U95 of P10
study-goal-unit = mm
study-goal-hint = For planning a further study.
study-take-out = Remove { $name }
study-add-survey = Add a survey
study-choose-survey = Choose a survey
study-no-more-surveys = No other surveys
study-surveys-hint = Surveys of one site form one cluster. Years are compared if at least two are given.
study-choose-file = Choose file
study-choose-file-of = Choose file: { $table }
study-counted-words = { NUMBER($heights) } accepted heights of { NUMBER($vehicles) } vehicles at { $sites ->
    [one] { $sites } site
   *[other] { $sites } sites
}.
study-percentiles = Percentiles of true heights ({ $unit })
study-holds = Below each value: its total 95 % interval. It includes sampling of vehicles and sites, and errors that heights share (camera pose, mean inset). Random measurement error is removed from the values.
study-target = Target
study-n = n = { NUMBER($n) }
study-mean = Mean
study-sd = SD
study-effects = Design effects
study-effects-note = Design effect: variance under this design divided by that of a simple random sample of the same size. Effective n: number of heights divided by the design effect. Both are estimated from the differences between sites, so with few sites they are rough. A design effect below 1 (an effective n above the number of vehicles) is then due to chance.
study-figure = Figure
study-vehicles = Vehicles
study-effect = Design effect
study-effective = Effective n
study-weighting = From weights alone
study-years = Years compared
study-years-note = Later year minus first year, each weighted separately, with total 95 % intervals. A difference is called higher or lower if its interval excludes 0. Errors are taken as independent between the years; where years share errors, the intervals are too wide, never too narrow.
study-years-column = Years
study-years-of = { $first } to { $second }
study-beside = Comparison with another study
study-beside-with = Compare with
study-beside-none = No other study with results
study-beside-choose = Choose a study
study-beside-loading = the comparison
study-beside-title = { $second } minus { $first }
study-beside-note = Uses the latest results of each study, with total 95 % intervals. A difference is called higher or lower if its interval excludes 0 (risk of at most 2.5 % on either side, for each value separately). Errors are taken as independent between the studies; where studies share errors (a site, a mean inset), the intervals are too wide.
study-beside-shared = Both studies contain { $surveys }. Shared errors partly cancel, so these intervals are too wide.
study-errors = Error against manufacturers’ heights
study-errors-note = Measured minus the manufacturer’s height of roofs, not rounded, with 95 % CI.
study-lighting = Lighting
study-bias = Bias
study-all = all
study-classes = Vehicle classes
study-classes-note = Shares as sampled, with 95 % CI, compared with the fleet.
study-class = Class
study-share = Share
study-fleet-share = Fleet
study-plan = Next study: U95 of P10 within { $goal }
study-plan-note = Vehicles needed at each site, if sites and vehicles vary as they do here. Not reachable: at so few sites no number of vehicles is enough.
study-plan-sites = Sites
study-plan-none = not reachable
study-curve-title = { $target }: true heights
study-curve-says = Cumulative distribution of true heights, { $target }, with its band.
study-curve-note = Band: total 95 % intervals of the percentiles, joined. Dashed: random measurement error not removed.
study-curve-true = true heights
study-curve-raw = random error not removed

surveys-card = <made>{ $recordings ->
    [one] { $recordings } recording
   *[other] { $recordings } recordings
} · { $day }</made>
surveys-card-with-site = { $site } · <made>{ $recordings ->
    [one] { $recordings } recording
   *[other] { $recordings } recordings
} · { $day }</made>
surveys-vehicles-measured = Vehicles measured or not visible
surveys-heights-reviewed = Heights reviewed{ $scans ->
    [0] { "" }
   *[other] { "" } (frames and line scans)
  }
surveys-scans-reviewed = Line-scan vehicles reviewed
surveys-scans = Line scans: { $summary }
surveys-simulated = { $count ->
    [one] Simulated study: 1 survey
   *[other] Simulated study: { NUMBER($count) } surveys
}
surveys-simulated-help = Nothing was filmed here; these surveys demonstrate statistics, standards and <link>studies</link>.
surveys-all-done = All steps done
surveys-tally = { NUMBER($done) } <muted>of { NUMBER($all) }</muted>

## Sign in: the page

signin-loading = your account
signin-link-title = Your sign-in link
signin-with-password = Sign in with a password
signin-email = E-mail
signin-password = Password
signin-submit = Sign in
signin-help = No password yet? Use the one-time link: the server prints it when it first starts, and an administrator creates one for each new user.

## Account: the page

account-name = Name
account-email = E-mail
account-role = Role
account-password-change = Change the password
account-password-choose = Choose a password
account-no-password = You have no password yet. Without one you need a new link for each sign-in.
account-password-present = Current password
account-password-new = New password
account-password-hint = At least { NUMBER($least) } characters. Several words in a row are easy to remember.
account-password-short = { $count ->
    [one] { NUMBER($count) } character; at least { NUMBER($least) } are needed.
   *[other] { NUMBER($count) } characters; at least { NUMBER($least) } are needed.
}
account-password-again = Confirm new password
account-password-differs = The passwords differ. Enter the new password twice.
account-password-set = Set the password
account-password-is-set = Your password is set.
account-tokens = API tokens
account-tokens-loading = your tokens
account-tokens-none = No tokens yet
account-tokens-help = A token lets a program, such as a script or sightline import, act with some of your rights.
account-token-make = Create a token
account-token-make-action = Create
account-token-name = Name
account-token-scopes = Scopes
account-token-ends = Expires
account-token-used = Last used
account-token-ended = expired
account-token-never = never
account-token-revoke = Revoke
account-token-revoke-title = Revoke { $name }?
account-token-revoke-body = Programs that use it will be refused. This cannot be undone.
account-token-title = Token { $name }
account-token-once = Copy it into the program now; it will not be shown again. Whoever has it acts in your name.
account-token = Token
account-token-copied = The token is on the clipboard.
account-token-name-field = Name
account-token-name-hint = The program and the computer it runs on.
account-token-name-problem = Enter a name that says what the token is for.
account-token-scopes-field = Scopes
account-token-scopes-problem = Choose at least one.
account-token-days = Expires after
account-token-days-count = { $days ->
    [one] { $days } day
    [366] a year
   *[other] { $days } days
}
token-scope-read = read
token-scope-hint-read = See what you see, and compute heights without storing them.
token-scope-upload = upload
token-scope-hint-upload = Add recordings and find their passes.
token-scope-measure = measure
token-scope-hint-measure = Everything else an operator does: surveys, cameras, poses, measurements.
token-scope-review = review
token-scope-hint-review = Give verdicts and decide on lots.
token-scope-export = export
token-scope-hint-export = Make and download packages and the results of studies.
show-once-copy = Copy
show-once-done = Done

## People: the page

people-only-admin = Only administrators can manage accounts. Ask one if you need another role.
people-lead = Accounts and roles. A person sees the surveys that are open to everyone and those they are a member of; administrators see every survey.
people-loading = users
people-add = Add a user
people-name = Name
people-role = Role
people-state = State
people-last-seen = Last sign-in
people-actions = Actions
people-you = (you)
people-role-of = Role of { $person }
people-no-password = no password yet
people-never = never
people-new-link = New link
people-switch-off = Deactivate
people-switch-on = Reactivate
people-role-title = Change { $person }’s role to { $role }?
people-role-body = Rights of { $person } afterwards: { $does }
people-role-change = Change the role
people-switch-off-title = Deactivate { $person }’s account?
people-switch-off-body = They are signed out and cannot sign in again. Their work stays under their name.
people-does-viewer = sees open surveys and those they are a member of, exports packages
people-does-operator = adds recordings, calibrates, measures
people-does-reviewer = everything an operator does, and reviews other people’s work
people-does-admin = everything, including accounts

## People: adding one

people-add-action = Add
people-add-name = Name
people-add-name-problem = Enter the name as it should appear beside their work.
people-add-email = E-mail
people-add-email-hint = Used to sign in. Sightline sends no e-mail: you pass on the sign-in link that comes next.
people-add-email-problem = Enter an e-mail address, for example ada@example.org.
people-add-role = Role
people-link-title = Sign-in link for { $person }
people-link-help = Send this link to { $person }. It works once, expires in 7 days, and will not be shown again.
people-link = Sign-in link
people-link-copied = The link is on the clipboard.

## Audit: the page

audit-lead = Every change is one event in a hash chain. Any later edit or deletion breaks the chain.
audit-numbers = Each survey has its own chain; changes outside surveys have another. Numbers count the events of a chain, so a filtered list has gaps. Check the chain to see whether an event is missing.
audit-loading = the audit trail
audit-survey = Survey
audit-survey-all = All
audit-what = Changed item
audit-what-all = Everything
audit-none-title = No events here
audit-none-filtered = No events match the filters.
audit-none = No changes recorded yet.
audit-events = Audit events
audit-number = No.
audit-when = When
audit-who = Who
audit-did = Action
audit-changes = Changes
audit-hash = Hash
audit-older = Show older events
audit-hash-after = { $hash }, after { $previous }
audit-hash-first = { $hash }, first event
audit-check = Check the chain
audit-whole-title = The chain is intact
audit-whole = { $count ->
    [one] { NUMBER($count) } event checked; the last hash is <code>{ $hash }</code>.
   *[other] { NUMBER($count) } events checked; the last hash is <code>{ $hash }</code>.
}
audit-event-missing = Audit event { $number } of { $chain } is missing; restore a backup.
audit-event-changed = Audit event { $number } of { $chain } was changed after it was written; restore a backup.
audit-event-incomplete = Audit event { $number } of { $chain } lacks what such an event holds; restore a backup.
audit-chain-ends-elsewhere = The audit chain of { $chain } ends at event { $number }, which is not where it ended; restore a backup.
audit-chains-not-signed = The audit chains are not those signed on { $at }; restore a backup.
audit-no-checkpoint = This is no checkpoint, or its signature does not hold; give the file that `sightline checkpoint` wrote, or the checkpoint.json of a package.
audit-checkpoint-elsewhere = The checkpoint of { $at } did not sign the audit chain of this package: it is of another survey or installation, or from before this survey.
audit-chain-ends-before = The audit chain { $chain } ends with event { NUMBER($last) }, before event { NUMBER($event) }, which the checkpoint of { $at } signed: it was cut, is older than the checkpoint, or is of another installation.
audit-chain-differs = Event { NUMBER($event) } of the audit chain { $chain } is not the one that the checkpoint of { $at } signed: the chain was rewritten, or is of another installation.
audit-vouched-events = What was given vouches for { NUMBER($vouched) } of { NUMBER($count) } events, not for those that came later.
audit-chain-not-exported = The audit chain is not the one in package { $id }; restore a backup.
audit-row-not-events = The { audit-thing } { $id } is not what its audit events state; restore a backup.
audit-row-not-first = The { audit-thing } { $id } is not what was first written; restore a backup.
audit-row-removed = The { audit-thing } { $id } was removed without an audit event; restore a backup.
audit-thing = { $entity ->
    [calibration] calibration
    [click_sigma] click uncertainty
    [computing] record of heights computed again
    [frames] frame table of recording
    [line_pose] calibration of a line camera
    [lot] lot
    [lot_decision] decision on a lot
    [lot_items] items of lot
    [measurement] measurement revision
    [photograph] photograph of the set-up
    [pose] camera pose
    [review] review
    [rig_calibration] calibration of a rig
    [scan] line-scan recording
    [scan_measurement] scanned vehicle’s measurement
    [scan_reference] reference value of a scanned vehicle
    [scan_review] scanned vehicle’s review
    [scan_run] run over a line-scan recording
    [scan_vehicle] scanned vehicle
    [series] measurement
    [study] study
    [study_result] result of a study
    [wheel_pair] pair of tyre contacts
   *[vehicle] vehicle
}
audit-broken-title = The chain is broken

## Audit: what was done, and to what

audit-action-calibrate = calibrated
audit-action-cancel = cancelled
audit-action-cancelled = stopped
audit-action-check_drift = checked the camera stability of
audit-action-choose = chose
audit-action-choose_calibration = chose the calibration of
audit-action-create = created
audit-action-decide_drift = decided on the camera stability of
audit-action-delete = removed
audit-action-detect = found the board in
audit-action-draw = drew
audit-action-done = finished
audit-action-failed = failed at
audit-action-finish = finished
audit-action-fix = fixed
audit-action-import = imported
audit-action-ingest = imported
audit-action-ingest_failed = could not import
audit-action-order = ordered
audit-action-propose = made
audit-action-read = imported
audit-action-recorded = recorded
audit-action-reading_failed = could not import
audit-action-release = requeued
audit-action-requeue = requeued
audit-action-request = requested the statistics of
audit-action-restart_ingest = restarted the import of
audit-action-restart_reading = restarted the import of
audit-action-restore = restored
audit-action-retire = retired
audit-action-review = reviewed
audit-action-revise = changed
audit-action-revoke = revoked
audit-action-run = ran
audit-action-seal = sealed
audit-action-set_password = set the password of
audit-action-sign = signed
audit-action-take = took
audit-action-sign_out = signed out
audit-action-swap_cameras = swapped the cameras of
audit-action-take_back_drift_decision = undid the decision on the camera stability of
audit-action-update = changed
audit-action-use = used
audit-action-compute_again = computed again
audit-action-undo = undid
audit-action-accepted = accepted
audit-action-full_inspection = sent to full inspection
audit-action-dissolved = dissolved
audit-action-taken_back = undid
audit-action-withdraw = withdrew
audit-entity-survey = survey
audit-entity-survey_member = member
audit-entity-camera = camera
audit-entity-calibration_image = calibration image
audit-entity-calibration = calibration
audit-entity-recording = recording
audit-entity-upload = upload
audit-entity-pose = camera pose
audit-entity-photograph = photograph
audit-entity-catalogue = catalogue
audit-entity-vehicle = vehicle
audit-entity-measurement = measurement
audit-entity-proposals = suggested points
audit-entity-review = verdict
audit-entity-computing = heights computed again
audit-entity-review_plan = review plan
audit-entity-free_plan = plan of hidden suggestions
audit-entity-wheel_pair = wheel pair
audit-entity-click_sigma = click uncertainty
audit-entity-standards = standards
audit-entity-scan = line scan
audit-entity-scan_run = vehicle search of a line scan
audit-entity-lot = lot
audit-entity-lot_decision = decision on a lot
audit-entity-scan_vehicle = scanned vehicle
audit-entity-scan_measurement = scanned vehicle’s measurement
audit-entity-scan_review = verdict on a scanned vehicle
audit-entity-scan_reference = reference value
audit-entity-line_pose = calibration of a line camera
audit-entity-rig_calibration = rig calibration
audit-entity-export = package
audit-entity-evidence = evidence file
audit-entity-study = study
audit-entity-study_result = result of a study
audit-entity-study_member = member of a study
audit-entity-package = package seal
audit-entity-checkpoint = checkpoint
audit-entity-signing_key = signing key
audit-entity-person = person
audit-entity-sign_in_link = sign-in link
audit-entity-api_token = API token
audit-entity-job = job
audit-subject-vehicle = vehicle { $vehicle }
audit-subject-target = vehicle { $vehicle }, { $target ->
    [roof] roof
    [driver_eye] driver’s eye
    [taillight] taillight
    [headlight] headlight
   *[other] other
}
audit-subject-verdict = { $subject }: { $verdict }
audit-subject-named = { $entity } “{ $name }”
audit-person = Person
audit-person-all = All
audit-day = Day (UTC)
audit-vehicle = Vehicle number
audit-vehicle-problem = Enter a whole number.
audit-row = database row { $id }

## Export: the page

excluded-withdrawn = The measurement was withdrawn.
excluded-not-reviewed = It has not been reviewed yet.
excluded-not-selected = It is not among the vehicles of this package.
excluded-no-height = There is no height.
excluded-rejected = It was rejected by a reviewer.
excluded-reopened = It was reopened and is waiting for another review.
excluded-check-target = It is a check target: its errors are in statistics/errors_by_target.csv.
excluded-without-time = This package is limited to days or hours of filming, and the start of its recording is not confirmed.
excluded-out-of-sample = Its vehicle is outside the survey’s sample.
export-lead = Download the data, report and audit trail.
export-crops = with images of the clicks
export-of-title = Vehicles in statistics and report
export-of-lighting = Lighting
export-of-filmed-from = filmed from { $day }
export-of-filmed-to = filmed up to { $day }
export-of-hours = filmed between { $begins } and { $ends }
export-of-nights = { $days ->
    [one] filmed in the night that begins on { $first }, { $begins } to { $ends }
    [since] filmed in the nights that begin on { $first } or later, { $begins } to { $ends }
    [until] filmed in the nights that begin on { $last } or earlier, { $begins } to { $ends }
   *[several] filmed in the nights that begin on { $first } to { $last }, { $begins } to { $ends }
}
export-of-help = Statistics, figures and report cover these vehicles only, as the first page of the report states; the traffic of line scans is limited by days and hours alone, since flow and headways are of all vehicles. The tables are complete, so that the audit trail covers them; exclusions.csv lists what is excluded.
export-of = Vehicles
export-of-all = all vehicles
export-build = Build the package
export-ready = The package is ready.
export-failed = The package could not be built. Try again.
export-open-note = Each row shows its review status. For a final package, <link>complete the review</link> first.
export-packages = Packages
export-outdated = Outdated, { $what } since
export-since-heights = { $count ->
    [one] { NUMBER($count) } height
   *[other] { NUMBER($count) } heights
}
export-since-reviews = { $count ->
    [one] { NUMBER($count) } verdict
   *[other] { NUMBER($count) } verdicts
}
export-since-other = { $count ->
    [one] { NUMBER($count) } other change
   *[other] { NUMBER($count) } other changes
}
export-loading = packages
export-none-title = No packages yet
export-none = Press “Build the package”. It takes a few seconds to a few minutes, depending on the number of images. You can continue working meanwhile.
export-made = Built
export-language = Report language
export-size = Size
export-sha256 = SHA-256
export-audit-head = Audit head of the package
export-download-column = Download
export-download = Download
export-sha256-copy = Copy the SHA-256
export-sha256-copied = The SHA-256 is on the clipboard.
export-audit-head-copy = Copy the audit head
export-audit-head-copied = The audit head is on the clipboard.
export-checking = Checking a package
export-checking-help = Checks every file, the audit chain, its signature and each row against it, and computes every height and statistic again. Send this installation’s key (or the SHA-256) separately from the package. It reveals a package that was replaced and signed with another key. A signature proves what the holder of the key signed, not that it is true.
export-command-copy = Copy the command
export-command-copied = The command is on the clipboard.

## Export: what is in a package

export-contents = What is in a package
export-contents-report = set-up, calibration, method, errors, figures and exclusions on a few pages
export-contents-measurements = current measurements: vehicle, target, frame, height and its uncertainty
export-contents-exclusions = excluded measurements and reasons
export-contents-statistics = error table, percentiles, distributions and corrections as CSV; figures as SVG
export-contents-crops = the image that each measurement was made on, unmarked and with its points
export-contents-revisions = every revision with its clicks and its uncertainty budget
export-contents-clicks = the clicks alone; “sightline height” computes the same heights from them
export-contents-vehicles = make, model, year, manufacturer’s height and its source, lighting
export-contents-recordings = file hashes, and the time stamp and checksum of each frame measured on
export-contents-poses = camera poses and lens parameters, as tables and as JSON
export-contents-classes = vehicle classes with their sets; the vehicles that statistics and report cover
export-contents-insets = current insets; wheel pairs, for the travel direction
export-contents-reviews = verdicts and reasons, and the blind repeats
export-contents-audit = each change with its hash; the chain can be checked
export-contents-datapackage = name, unit and meaning of every column (Frictionless Data)

## Proposals: why a point of a passing vehicle is not proposed (kept by key)

proposals-not-across = The vehicle moves up or down the frame. Suggestions need one that crosses it.
proposals-no-empty-road = Too few frames before and after the vehicle show the empty road.
proposals-not-one-vehicle = The wheels found on different frames do not belong to one vehicle.
proposals-wheels-on-few-frames = Wheels stand out from shadow and body on too few frames.
proposals-wheel-on-best-frame = This wheel does not stand out from shadow and body on the best frame.
proposals-not-in-picture = It is outside the frame on the best frame.
proposals-no-wheel = No wheel stands out from shadow and body on these frames.
proposals-no-height = This point gives no height; click it yourself.
proposals-roof-not-seen = The roof’s near edge was detected on too few frames; click it yourself.
proposals-taillight-not-seen = The rear lamp was detected on too few frames; click its lower edge yourself.
proposals-headlight-by-hand = The middle of a headlight cannot be found reliably yet; click it yourself.
proposals-eye-not-seen = The driver’s eye was detected on too few frames; if you see it, click it yourself.
proposals-hidden-here = It is not visible on the best frame.
proposals-no-contact = No tyre contact is suggested on this frame, so no height would follow; click both yourself.
proposals-too-uncertain = It was not located precisely enough for a height; click it yourself.


## Proposals: the job, and what is refused

proposals-looking = Searching for points to suggest.
proposals-made = Suggestions in { NUMBER($some) } of { NUMBER($passes) } passes, points in all: { NUMBER($points) }.
proposals-being-made-already = Points are already being suggested for { $name }; wait until that has finished.
proposals-no-found-passes = { $name } has no passes found by Sightline. Find the passes first.
second-frame-followed = The vehicle was followed through its pass.
second-frame-measured = Its speed is that of the points clicked on two frames.
second-frame-assumed = The vehicle could not be followed; its speed is assumed, so look for the points around the marks.
snap-measured-free = This vehicle was drawn to be measured without suggestions.
anchoring-too-few = Too few: five vehicles of each kind are needed.
proposals-withheld = Suggestions are hidden for this vehicle, drawn at random to learn how much they influence people. Click it yourself.
proposals-somebody-changed-plan = The share of vehicles with suggestions hidden was changed meanwhile. Check it and choose again.
proposals-plan-one-in = Hide the suggestions for one vehicle in 2 to { $most }, or for none (0).
measurements-click-elsewhere = The contact is not where Sightline now places such a click: the camera pose or the suggestions changed. Click the contact again.
snap-no-tyre = No tyre on the road was found at this click; the click is kept as it is.
snap-out-of-reach = The nearest tyre found is too far from this click; the click is kept as it is.
snap-not-sure = A tyre was found near this click, but not reliably enough; the click is kept as it is.
measurements-proposals-not-these = These points are out of date: the suggestions were made again. Check and confirm them again.


## Heights: why there is none, and what to know of one; what is followed and suggested (kept by code)

height-click-not-finite = A click coordinate is not a finite number.
height-contact-outside-picture = The contact point lies outside the frame.
height-target-outside-picture = The target point lies outside the frame.
height-contact-outside-lens = The contact point lies outside the lens model’s valid radius, so its direction is unknown.
height-target-outside-lens = The target point lies outside the lens model’s valid radius, so its direction is unknown.
height-camera-below-road = The pose puts the camera on or below the road; compute the camera pose again.
height-contact-above-horizon = The contact point lies at or above the horizon, where there is no road.
height-contact-behind-camera = The contact point lies behind the plane of the camera, as seen across the road.
height-plane-edge-on = The side plane through the contact point is seen nearly edge-on.
height-target-no-crossing = The line of sight to the target does not meet the side plane in front of the camera.
height-target-below-road = The target lies on or below the road; were contact and target swapped?
height-u-not-valid = A click uncertainty, inset or inset uncertainty is not a finite number, or an uncertainty is negative.
height-side-unknown = The driver’s side (near or far) is not set, and the height of the eye depends on it; set it.
line-height-extrapolated = A click lies outside the rows covered by the marks, so the pose is extrapolated.
line-height-click-no-number = A click is not a number.
line-height-contact-above-horizon = The contact is at or above the horizon, where there is no road; click the tyre contact.
line-height-target-below-contact = The target is not above the contact; click the contact first, then the target.
line-height-target-behind-camera = The inset puts the target behind the camera.
line-height-beside-vehicle = A click lies outside the vehicle’s front and rear; it may belong to another vehicle.
height-inset-implausible = The computed inset of { NUMBER($inset_m, minimumFractionDigits: 2, maximumFractionDigits: 2) } m is not plausible for a road vehicle ({ $low_m } to { $high_m } m): contact and target must be the same points in every frame.
height-no-board-in-picture = The whole board does not fit in the image, so the camera pose cannot be computed.
height-picture-too-narrow = The frame shows contact and target over { NUMBER($shown_m, minimumFractionDigits: 1, maximumFractionDigits: 1) } m of the wheel path only, so they cannot be clicked twice with { $travel_m } m between.
height-frames-too-few = Contact and target are needed in at least two frames.
height-of-frame = Frame { $frame } of { $frames }: { $reason }
height-travel-short = The vehicle moved only { NUMBER($travel_m, minimumFractionDigits: 2, maximumFractionDigits: 2) } m between the frames; choose frames further apart.
height-clicks-disagree = The clicks do not fit one moving vehicle; click the same two points in every frame.
height-inset-undetermined = The frames do not determine the inset; choose frames further apart.
height-no-clicks = Contact and target give no height.
height-pass-empty = No point was followed; confirm contact and target on one frame first.
height-pass-not-finite = A followed point, its time or its uncertainty is not a finite number.
height-pass-u-not-positive = The uncertainty of a followed point is not positive; state it in pixels.
height-pass-statement-not-valid = An exposure, a row time or an uncertainty of the following is negative or too large; correct it.
height-pass-point-twice = A point is given twice on one frame; give each once.
height-pass-few-frames = The { $point ->
        [contact] contact
        [second_contact] second contact
       *[target] target
    } was followed on { NUMBER($count) } usable frames; { $needed } are needed.
height-pass-short = The { $point ->
        [contact] contact
        [second_contact] second contact
       *[target] target
    } was followed over only { NUMBER($travel_m, minimumFractionDigits: 2, maximumFractionDigits: 2) } m; follow it over more frames.
height-pass-no-path = The followed points do not give a path on the road; follow them again.
height-pass-disagrees = The followed points do not fit one moving vehicle; follow them again.
height-pass-inset-undetermined = The frames do not determine the inset; follow the points over a longer distance.
height-pass-most-excluded = { NUMBER($dropped) } of { NUMBER($points) } followed points were excluded; follow them again from a clearer frame.
height-flag-plane-oblique = The side plane is seen at less than 10 degrees.
height-flag-lens-edge = A click is near the edge of the lens model’s valid radius.
height-flag-far-from-board = The vehicle’s distance differs strongly from the board’s.
height-flag-u-large = The 95 % interval is approximate: u is above 30 mm.
height-flag-no-u-of-lens-and-pose = The uncertainty of lens and pose is unknown and not included.
height-flag-no-u-of-lens = The uncertainty of the lens is unknown; only what the pose file states is included.
height-flag-no-board = The board is unknown, so its tilt, height, square size and bow are not included in the uncertainty.
height-flag-no-square-size = The pose does not state the board’s square size; not included in the uncertainty.
height-flag-no-bow = The pose does not state the board’s bow; not included in the uncertainty.
height-flag-no-square-size-and-bow = The pose does not state the board’s square size and bow; not included in the uncertainty.
height-flag-clicks-misfit = The clicks do not fit straight, level travel; check that the same points were clicked in every frame.
height-flag-inset-weak = The frames are too close together to determine the inset well.
height-flag-pass-misfit = The followed points deviate from straight, level travel by more than their uncertainty.
height-flag-side-from-place = The pass has no direction; the driver’s side follows from the camera’s place in the median, past which all traffic runs one way.
height-flag-camera-moved = The camera moved { NUMBER($moved_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px after the pose was computed; compute a new pose for this part, or decide to keep the old one.
height-flag-camera-moved-by = The camera moved { NUMBER($moved_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px after the pose was computed (height error up to { SMALL($error_m, digits: 0) } on the nearest road in the picture, more beyond); compute a new pose for this part, or decide to keep the old one.
height-flag-camera-moved-height = The camera moved { NUMBER($moved_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px after the pose was computed (height error at these clicks: { SMALL($error_m, digits: 0) }); compute a new pose for this part, or decide to keep the old one.
height-flag-inset-zero = inset taken as 0
height-flag-u-inset-zero = uncertainty of the inset taken as 0
height-flag-usual-inset = usual inset of { $target }
height-flag-usual-inset-of-side = usual inset of { $target }, { $side }
height-target-unknown = The target { $target } is not one of { $known }.
height-side-not-known = The side { $side } is not one of { $known }.
second-frame-no-height = There is no height yet; click contact and target first.
second-frame-no-other = The pass has no other frame; extend it by its first or last frame.
second-frame-not-shown = No other frame of the pass shows both points; use a single frame.
second-frame-no-gain = A second frame does not help: { SMALL($now_m, digits: 0) } now, { SMALL($then_m, digits: 0) } with it.
followed-off = It is { NUMBER($off_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px from the position given by the other frames, { NUMBER($times, minimumFractionDigits: 1, maximumFractionDigits: 1) } times its uncertainty.
followed-outside-picture = It lies outside the frame.
followed-outside-lens = It lies outside the lens model’s valid radius.
followed-above-horizon = It lies at or above the horizon, where there is no road.
followed-left-picture = It has left the frame.
followed-lost = It was lost: nothing is found where speed and camera pose place it.
followed-elsewhere = Its position disagrees with the neighbouring frames.
followed-unlike = The image is too unlike the other frames here; it may be hidden.
followed-blurred = It is too blurred here compared with the other frames.
followed-weak = Too little detail is visible here to locate it within 1.5 px.
follow-outline = This target is an outline against a moving background and cannot be followed; click two frames.
follow-frame-not-of-pass = The confirmed points are on a frame outside the pass.
follow-not-from-here = The vehicle cannot be followed from this frame; confirm the points on another one.
follow-points-needed = Following starts from a frame with contact and target; click both on it.
contact-wrong-distance = The road is too near or too far here to detect a wheel.
contact-oblique = The wheel is seen too obliquely here; its tread hides the contact.
contact-no-rim = No complete rim is visible here, so the tyre cannot be separated from shadow and body.
contact-no-edge = The lower edge of the tyre does not stand out from the road here.
contact-radius = The wheel detected here would have a radius of { NUMBER($radius_m, minimumFractionDigits: 2, maximumFractionDigits: 2) } m.
contact-far-from-pointer = The detected wheel is too far from the pointer; point closer to its contact.
contact-none = No suggestion. { $reason } Click the contact yourself.
contact-found = suggested contact, u = { NUMBER($expected_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px
contact-found-rough = suggested contact, u = { NUMBER($expected_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px, less accurate than a careful click
heading-of-contact = The { $which ->
    [first] first
   *[second] second
 } tyre contact: { $reason }
heading-base-short = The two tyre contacts are only { NUMBER($base_m, minimumFractionDigits: 2, maximumFractionDigits: 2) } m apart on the road; click the front and the rear tyre of the same side.
heading-base-long = The two tyre contacts are { NUMBER($base_m, minimumFractionDigits: 0, maximumFractionDigits: 0) } m apart on the road; click both tyres of one vehicle.
heading-at-edge = A tyre contact lies at the edge of the visible road; use another frame.
heading-outlier = Excluded as an outlier; check its clicks.
size-not-measured = It is not measured.
size-rejected = Its measurement was rejected.
size-no-tyres = No frame has both tyres clicked.
drift-unknown = Camera movement cannot be determined: { $reason }
drift-still = No camera movement detected, within { NUMBER($floor_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px.
drift-still-of-height = No camera movement detected, within { NUMBER($floor_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px ({ SMALL($floor_m, digits: 1) } of height).
drift-moved = { $how ->
    [bumped] The camera moved
    [before] The camera had already moved
   *[drifted] The camera drifted
 } at { $clock } (frame { $frame }) by { NUMBER($moved_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px, frames { $first } to { $last }.
drift-moved-height = { $how ->
    [bumped] The camera moved
    [before] The camera had already moved
   *[drifted] The camera drifted
 } at { $clock } (frame { $frame }) by { NUMBER($moved_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px (height error up to { SMALL($error_m, digits: 0) } on the nearest road in the picture, different at other distances), frames { $first } to { $last }.
drift-more = { $count ->
    [one] { NUMBER($count) } more movement.
   *[other] { NUMBER($count) } more movements.
  }
drift-near = The height errors are those of a target { $target_m } m high, { $distance_m } m across from the camera.
drift-few-points = Only { NUMBER($count) } background points were found again, or all of them in one part of the frame; it is too dark, covered, or another view.
drift-no-frame = No frame was checked.
drift-no-such-frame = The recording has no such frame.
drift-nothing-in-pose-frame = The frame of the camera pose has nothing that can be followed; it is too dark or has too little contrast.
drift-recording-of-pose-deleted = The camera pose cannot be compared with this recording, because its recording was deleted; compute a new pose.
drift-other-size = The frame size differs from that of the camera pose.
drift-no-target = No target { $target_m } m high on the road between 3 and 12 m is in the frame.

## Errors: cameras

cameras-charuco-incomplete = A ChArUco board needs the dictionary of its markers, the marker side and the square size; give all three.
cameras-checkerboard-without-markers = A checkerboard has no markers; choose ChArUco as the kind of board, or leave out dictionary and marker.
cameras-frames-outside = Frames { $first } to { $last } are not in the recording; it has frames 0 to { $frame_count }.
cameras-too-many-views = Every { $every }th frame gives { NUMBER($count) } views; take every { $least }th frame or fewer frames.
cameras-not-text = { $file_name } is not a text file; choose a calibration as YAML, JSON or cameramodel.
cameras-not-a-file = { $path } is not a file; give image files or a clip.
cameras-still-without-tracks = { $path } is an image, not a video with tracks; leave --stream out.
cameras-no-image-size = Choose a calibration, or give the image’s width and height in pixels and its horizontal field of view in degrees.
cameras-calibration-other-survey = Calibration { $calibration_id } belongs to another survey; choose one of this survey’s cameras.
cameras-calibration-camera-changed = calibrations.csv: { $id } names another camera than the audit events; the table was changed.
cameras-taken-without-calibration = Camera { $camera } has no calibration to copy; calibrate it in its own survey, or add it here as a new camera.
cameras-taken-from-itself = Camera { $camera } belongs to this survey already; choose one of another survey.
cameras-no-name = A camera needs a name; enter one.
cameras-calibration-other-camera = Calibration { $calibration_id } belongs to another camera; choose one of this camera’s.
cameras-image-gone-meanwhile = An image was removed while the calibration ran; calibrate again.
cameras-image-without-reason = An image without a board needs a reason; state what was searched for.
commands-baseline-or-rig = Give either --baseline (with --u-baseline) or --rig.

## Errors: commands

commands-not-percentile = “{ $part }” is not a percentile; give numbers between 0 and 100, such as --percentile 2.5,10,50.
commands-no-heights = { $path } has no row with a height; give a file with rows whose status is ok.
commands-heights-without-counts = { $name } has verdicts and no column counts, so it does not say which heights count. Give the heights.csv that `sightline height` makes from the clicks.csv of the package.
commands-not-a-rig = { $path } is not a rig: a JSON object with baseline_m, as `sightline rig calibrate -o` writes it, and with lanes that have a distance_m each.
commands-too-large = { $path } is larger than 200 MB; give { $what }.
commands-not-exist-give = { $path } does not exist; give { $what }.
commands-not-utf8 = { $path } is not UTF-8 text; give { $what }, saved as UTF-8.
commands-cannot-read-give = { $path } cannot be read ({ $strerror }); give { $what }.
commands-not-json = { $path } is not readable JSON; give { $what }.
commands-not-writable = { $path } cannot be written ({ $strerror }); choose another place.
commands-stream-camera-missing = Camera { $name } cannot be opened ({ $error }); check its cable, power and address, and that no other program uses it.
commands-stream-camera-rows = Camera { $name } delivers lines of { $width } pixels, but { $rows } were requested; give --rows { $width }, or change the camera setting.
commands-stream-empty = Standard input ended before one pair of lines ({ NUMBER($pair_bytes) } bytes) arrived; start the cameras first, and check --rows.
commands-stream-follow-missing = { $path } cannot be read ({ $strerror }); give the file that the cameras’ program is writing.
commands-stream-no-aravis = GigE Vision cameras need Aravis and PyGObject, which are not installed ({ $error }); install gir1.2-aravis-0.8 and python3-gi, or give the lines on standard input.
commands-stream-no-token = A token is needed: make one in Account with read, upload and measure, and set SIGHTLINE_TOKEN to it.
commands-stream-other-rig = { $path } contains an interrupted stream (segment { $number }) recorded with other rows or another rig; start it with the same options to resume it, or choose another --spool.
commands-stream-server-needs = --server needs --survey, and --spool for the lines until the server has them; give both.
commands-stream-spool-taken = Another stream writes into { $path }; give this one another --spool.
commands-stream-two-cameras = Give --camera twice, first the camera that vehicles reach first, and no --follow with it.
commands-disk-full = { $path } cannot be written because the disk is full; free some space.
commands-charuco-marker-together = --charuco and --marker go together; give the dictionary and the marker’s side.
commands-board-form = --board { $text } does not have the form 9x6; count the inner corners across and down.
commands-size-form = --size { $text } does not have the form 1920x1080; give width and height in pixels.
commands-points-missing = Give --contact X,Y and --target X,Y, or --clicks with a CSV file.
commands-sigmas-not-finite = --sigma, --inset and --u-inset must be finite numbers, --sigma and --u-inset not negative; correct them.
commands-output-missing = Name the heights.csv to write with -o.
commands-point-form = { $option } { $text } does not have the form X,Y; give two numbers in pixels.
commands-problem = { $names }: { $message }
measurements-followed-not-readable = The followed points of a measurement cannot be read; they were changed.
measurements-followed-and-clicked = A pass is followed from the points on one frame; remove the other frames first.
measurements-not-followed = The vehicle cannot be followed: { $reason }
commands-follow-none = The vehicle cannot be followed: { $reason }
commands-tracks-alone = Give only one of these: --tracks; --contact and --target; --clicks.
commands-tracks-point = Row { $row } of { $path }: the point { $point } is not one of { $points }; correct the cell.
commands-tracks-frame = Row { $row } of { $path }: the frame is not a whole number; correct the cell.
commands-points-or-clicks = Give either --contact and --target or --clicks, not both.
commands-option-without-effect = --{ $name } has no effect here; use { $instead } instead.
commands-output-folder-missing = { $output } cannot be written because its folder does not exist; choose another place.
commands-time-no-offset = { $option } { $text } has no offset from UTC; write it with one, as in 2026-05-04T06:00:00.000+02:00.
commands-time-cannot-read = { $option } { $text } is not a time that can be used; write it as 2026-05-04T06:00:00.000+02:00.
commands-u-without-start = --u-start needs --start.
commands-idle-without-follow = --until-idle needs --follow.
commands-flow-other-minutes = --interval { $text } cannot be used; give one or more of 1, 5, 15 and 60, as in 5,60.
commands-flow-not-there = { $place } does not exist; name a package, results of sightline linescan, or a folder of them.
commands-flow-folder-empty = { $place } contains no scanned vehicles; name a package, results of sightline linescan, or a folder of them.
commands-flow-no-start = { $path } does not state when its vehicles passed (front_at or start with an offset from UTC); make it again with sightline linescan --start.
commands-flow-no-vehicles = { $path } contains no vehicle; give the JSON of sightline linescan, which states the recorded duration.
commands-flow-no-rate = { $path } contains a single vehicle without a motion, from which the line rate does not follow; give the JSON of sightline linescan.
commands-start-u-range = --u-start { $u_s } is not a standard uncertainty of a start; give seconds from 0 to 3600.
commands-strip-twice = { $first } is given twice; give the strips of both cameras.
backup-none-here = { $folder } contains no complete backup (no manifest.json); run sightline backup again, or name another folder.
backup-other-format = { $folder } contains a backup in another format; use the version of Sightline that made it.
backup-manifest-damaged = { $path } was changed after the backup; use another backup.
backup-file-missing = { $name } is missing from the backup; use another backup, or run sightline backup again.
backup-file-changed = { $name } in the backup is not the file that was backed up; use another backup.
backup-folder-not-empty = { $folder } contains files that are not a backup; choose an empty folder or an earlier backup.
backup-folders-nested = One of { $folder } and the folder of data or media lies within the other; choose a separate folder, preferably on another disk.
backup-under-way = Another backup is being written to { $folder }; wait until it ends.
backup-database-not-copied = The database { $path } could not be copied ({ $said }); try again.
backup-of-another-installation = The folder contains a backup of another installation, or of a later state than this; choose another folder.
backup-other-tables = The backup has a table { $name } that this version does not know; restore it with the version that made it.
backup-rows-misfit = The rows of { $name } in the backup do not fit their table; use another backup.
backup-older-crosses-later = The backup is of an older version of Sightline; restore it into PostgreSQL, back that up with this version, and restore the new backup here.
backup-place-not-empty = { $place } is not empty; restore into a new or empty place.
backup-database-not-empty = The PostgreSQL database already has tables; restore into an empty one.
backup-chains-end-elsewhere = The audit chains in the backup’s database do not end as its manifest states; use another backup.
backup-chain-broken = The database in the backup does not verify: { $problem }
backup-anchors-of-postgresql = The audit chains of a backup of PostgreSQL are in no database yet; restore it and give --head and --checkpoint with that database.
backup-damaged-kept = { $problem } No new backup was made; the last good one, of { $at } UTC, is still in { $folder }.
backup-damaged-none-before = { $problem } No backup was made; { $folder } has no earlier one, only copies of the media files.
backup-no-earlier = { $folder } contains one backup only; leave out --earlier.
backup-media-missing = { $count ->
    [one] The backup is complete, but a media file that the database refers to is not in the media store: { $names }
   *[other] The backup is complete, but { NUMBER($count) } media files that the database refers to are not in the media store, such as { $names }
 }; look for it in an earlier backup.

commands-no-database = There is no database at { $path }; name its folder with --data-dir.
commands-cannot-used-correct = { $name } cannot be used ({ $said }{ $said_2 }); correct it.
commands-camera-or-size = Give either --camera, or --size and --field-of-view.
commands-options-without-baseline = --speed, --speed-error, --line-rate and --u-baseline need --baseline.
commands-plan-incomplete = Give --camera-height and --distance; or --baseline for a line scan.
commands-plan-without-speed = A line scan’s plan needs --speed and --speed-error beside --baseline.
commands-plan-without-camera = A line scan is planned without a camera and its position; leave those options out.
commands-metrics-port-taken = Metrics cannot be served on port { $port } of { $host } ({ $why }); choose another with SIGHTLINE_METRICS_PORT.
commands-folder-taken = Another server is using the folder { $folder }; stop it, or give this one its own folder with --data-dir.
commands-folder-cannot-written = The folder { $folder } cannot be written ({ $why }); check its permissions and the disk, or name another with --data-dir.
commands-port-taken = Port { $port } on { $host } cannot be used ({ $why }); choose another with --port.
commands-option-not-negative = { $option } must be a finite number of 0 or more; correct it.
commands-row-without-pass = { $path }, row { $row }: the cell pass is empty; name the pass of every point.
commands-problem-2 = { $place }: { $problem }
commands-distance-or-speed = Give either --distance or --speed, not both.
commands-grade-without-distance = --grade-difference needs a sight distance; give --distance or --speed too.
commands-sag-needs-distance = --headlight needs a sight distance; give --distance or --speed too.
commands-height-or-heights = Give either --{ $name }, with its u if known, or --{ $name }-heights with a file.
commands-heights-several-targets = { $path } has heights of { $targets }; give a file with the heights of one target.
commands-too-few-heights = { $path }: { $reason }. Measure more, or choose a percentile nearer to the median.
commands-place-ambiguous = { $place } holds { $names }, which belong to different things: one could hide the other. Move out what does not belong there, and check it apart.
commands-place-missing = { $place } does not exist; name a database, a data folder or the folder of a package.

## Errors: demo


## Errors: export

export-frame-not-clicked = Frame { $frame } of the stored video is not the frame that was clicked on.
export-format-not-known = The package has format { $format }, which this version of Sightline does not know; verify it with { $program } or later.
export-made-by-another-version = Made by version { $program }; this is { $mine }.
export-described-otherwise = datapackage.json lists every file with its size and hash; its descriptions of { $count ->
    [one] one file
   *[other] { NUMBER($count) } files
  } (and: { $names }) are those of that version; covered by the seal, not compared.
export-statistics-sealed-only = Statistics differ from those of this version because another version computed them; covered by the seal, not compared (first difference: { $difference })
export-drawings-sealed-only = Figures, report and README were made by another version; covered by the seal, not compared.
export-page-sealed-only = The page was made by another version: its tables were compared; its program is covered by the seal, not compared.
export-words-sealed-only = Reasons and flags were put into words by another version: their codes were compared; the words are covered by the seal, not compared.
export-heights-of-another-version = { $count ->
    [one] One number that another version computed differs
   *[other] { NUMBER($count) } numbers that other versions computed differ
  } from what this version computes; covered by the audit chain, not compared (first: { $first })
export-statistics-file-added = { $strange } does not follow from these statistics; it was added.
export-crop-added = { $there } is in no row of crops.csv; it was added.
export-crop-points-differ = crops.csv: { $path } has other points or frames than its measurement; one is wrong.
export-crop-hash = { $path } does not have the hash stated in crops.csv; it was replaced.
export-crop-size = { $path } is not an image of the size stated in crops.csv; it was replaced.
export-overlay-points = { $overlay } does not show the points of its measurement; it was changed.
export-description-unreadable = { $description } cannot be read; get the complete package again.
csv-package-no-code = A cell with a code and its values cannot be read ({ $cell }); it was changed.
export-description-differs = { $description } states another { $name } than the files and the chain; it was changed.
export-program-differs = { $description } describes { $named } differently from this version of Sightline; it was changed.
export-too-rows-changed = { $path } has too { $value } rows; it was changed.
export-drawn-file-differs = { $path } is not what these rows and statistics give; it was replaced.
export-line-differs = { $path }, line { $at }: { $name } states { $told }, the rows give { $found }; one is wrong.
export-crop-missing = { $path } is missing or named twice in crops.csv; get the complete package again.
export-head-too-short = The audit head is too short ({ NUMBER($count) } characters). Enter at least { $least_of_head }.
export-continues-event = The chain continues event { NUMBER($event) }, the last that what was given vouches for; it does not vouch for later ones.
export-head-differs = No audit chain here goes through the given audit head { $head }: it was cut or rewritten, it ends before that head, the head is of another survey, or it is that of a whole database, which changes with every event.
export-no-checksums = There is no { $checksums }, so this is not a complete package; export the survey again.
export-package-is-inside = The package is one level down, in { $inner }; give that.
export-read-only = { $folder } cannot be written. Every package is recorded in the audit trail; copy the folder to a disk that can be written, and export from there.
export-stray-files = { $count ->
    [one] The system put a file beside those of the package: { $names }
   *[other] The system put { NUMBER($count) } files beside those of the package: { $names }
 }. Delete what is named here and check again; no file of the package has been looked at yet.
export-zip-in-zip = { $place } contains { $inner }; unpack it and give that.
export-checksums-no-list = { $checksums } is not a list of hashes: it was changed or cut off after the export; get the complete package again.
export-file-renamed = { $path } is here as { $there }: file names were changed on the way; copy or unpack the package again with its names.
export-file-not-listed = { $strange } is not listed in SHA256SUMS: it was added, or the list was changed. Remove what you added, or get the complete package again.
export-file-changed = { $path } was changed after the export; get the complete package again.
export-checkpoint-form = checkpoint.json is not written as Sightline writes it; get the complete package again.
export-checkpoint-signature = checkpoint.json carries a signature that its key does not give; it was changed.
export-checkpoint-other-chain = checkpoint.json does not vouch for the end of audit.csv; one was changed.
export-checkpoint-keys = checkpoint.json does not show how its key follows from the earlier keys; it was changed.
export-checkpoint-other-key = Signed with key { $key }, not with the given key: this is from another installation, from before that key, or forged.
export-key-too-short = The key is too short. Enter at least its first { $least } characters.
export-no-seal = audit.csv does not end with the event that seals the package: it was cut off or changed; get the complete package again.
export-page-not-described = { $path } is not described by datapackage.json, or missing although it is; get the complete package again.
export-page-another-program = { $path } is not the page that datapackage.json names; get the complete package again.
export-page-carries-another = The page carries another { $path } than the package; get the complete package again.
export-seal-differs = { $path } is not what the package’s seal, the last event of audit.csv, states: it was changed, removed or added after the export, and the checksums with it.
export-event-of-other = audit.csv: event { $number } is shown or withheld against the package’s seal, or the chain does not begin with the survey; audit.csv was changed after the export.

## Errors: geometry

geometry-too-few-pictures = Only { $used } of { $given } images can be used and at least { $least } are needed; add images of the whole board, from different sides.
geometry-too-few-images = Only { $used } of { $given } images can be used and at least { $least } are needed; add images of the whole board, from different sides. { $file }: { $reason }
geometry-board-corner-count = A board of { $columns }x{ $rows } inner corners cannot be used; count the inner corners (where four squares meet), 3 to 60 in each direction.
geometry-square-implausible = A square of { $square_m } m is not plausible; give the side of one square in metres.
geometry-model-misfit = The { $model } model could not be fitted to these views; add views from different sides or use the other model.
geometry-size-not-calibrated = { $what } is { $width_px }x{ $height_px } px but the camera was calibrated at { $width_px_2 }x{ $height_px_2 } px; use a calibration made at the recording’s size.
geometry-dictionary-unknown = { $dictionary } is not a marker dictionary; use one of { $dictionaries }, as stated by the maker of the board.
geometry-markers-over-squares = Markers of { $marker_m } m do not fit squares of { $square_m } m; give the side of the black marker, which is smaller than its square.
geometry-board-marker-count = A board of { $columns }x{ $rows } inner corners has { $needed } markers, but { $dictionary } has { $held }; choose the dictionary that the board was made with.
adjustment-nothing-uncertain = the pose states neither its own uncertainty nor the board’s, so the traffic cannot change anything; make it with sightline pose.
adjustment-contradictory = { NUMBER($out) } of { NUMBER($passes) } passes contradict the others; check the known lengths, their uncertainties and which points were followed.
adjustment-does-not-settle = the passes do not converge to one pose; check that each point follows the same place of its vehicle.
geometry-key-wrong = { $what }: '{ $key }' must be { $wanted }; correct that key or make the file again.
geometry-format-is-another = { $what } is in the format { $found }, where { $wanted } is needed; give a file of that format.
geometry-not-an-object = { $what } must be a JSON object; write it with sightline or see docs/formats.md.
geometry-distortion-unsupported = { $file_name }: the distortion model '{ $word }' is not supported; plumb_bob, rational_polynomial, radtan, equidistant and fisheye are.
geometry-file-too-large = { $file_name } is too large for a calibration file; choose the file with the intrinsics.
geometry-opencv-xml = { $file_name } is OpenCV’s XML, which Sightline does not read; save it again from OpenCV under a name that ends in .yml (FileStorage then writes YAML).
geometry-states-no-distortion = { $file_name } states no distortion of the lens; add distortion_coefficients, or five zeros if the lens has none.
geometry-no-camera = { $file_name } contains no camera; give OpenCV YAML or JSON, ROS camera_info, a Kalibr camchain or a mrcal .cameramodel.
geometry-values-not-finite = { $file_name }: { $what } contains values that are not finite or too large; calibrate again.
geometry-size-not-whole = { $file_name }: the image size must be two whole numbers of pixels.
geometry-no-matrix = { $file_name } contains no camera matrix (camera_matrix or K); export the intrinsics with their distortion coefficients.
geometry-matrix-form = { $file_name }: the camera matrix must be 3x3 with 0 0 1 as its last row.
geometry-matrix-skew = { $file_name }: the camera matrix has a skew, which is not supported; calibrate without.
geometry-camera-not-named = { $file_name } contains no camera '{ $which }'; it contains { $cameras }.
geometry-key-written-twice = { $file_name } contains the key “{ $key }” twice; keep the right one.
geometry-rows-contradict = { $file_name }: { $what } states { $rows } rows and { $columns } columns but contains { NUMBER($count) } numbers; export the file again.
geometry-camera-not-calibrated = { $file_name }: the camera matrix is all 0, so the camera was not calibrated; calibrate it first.
geometry-roi-contradicts-size = { $file_name }: the part of the image (roi) does not fit the image’s size; give the camera_info of whole images.
geometry-focal-implausible = { $file_name }: a focal length of { $focal } is not plausible for images { $width } px wide; it must be in pixels.
geometry-lens-turns-back = { $file_name }: with these distortion coefficients the lens model folds back near the middle of the image; check their order and the lens model.
geometry-model-unsupported = { $file_name }: the camera model '{ $camera_model }' is not supported; calibrate as pinhole.
geometry-intrinsics-count = { $file_name }: intrinsics must be four numbers, fu fv pu pv.
geometry-lens-unsupported = { $file_name }: the lens model { $word } is not supported; convert it with mrcal-convert-lensmodel to LENSMODEL_OPENCV8.
geometry-needs-intrinsics-file = { $file_name }: { $word } needs { $value } intrinsics, the file has { NUMBER($count) }.
geometry-no-image-size = { $file_name } does not state the image size; add image_width and image_height to it.
geometry-focal-not-positive = { $file_name }: the focal lengths must be positive numbers of pixels.
geometry-principal-point-outside = { $file_name }: the principal point lies far outside the image; correct the image size.
geometry-thin-prism = { $file_name }: thin-prism and tilt coefficients are not supported; calibrate with at most eight.
geometry-distortion-count = { $file_name }: { NUMBER($count) } distortion coefficients; 4, 5 or 8 are supported.
geometry-camera-unreadable = { $file_name } is not a readable camera file; give OpenCV YAML or JSON, ROS camera_info, a Kalibr camchain or a mrcal .cameramodel.
geometry-not-numbers = { $file_name }: { $what } is not a list of numbers; export the file again.
geometry-size-not-two = { $file_name }: the image size must be two numbers, width and height.
geometry-camera-info-binned = { $file_name }: { $key } is { $data }; give the camera_info of unbinned images.
geometry-fisheye-count = { $file_name }: a fisheye model needs four coefficients, the file has { NUMBER($count) }.
geometry-board-not-found = The board was found in none of the { NUMBER($count) } frames. { $reason }
geometry-pose-misfit = No pose fits the corners; check that the camera file belongs to this recording and that the whole board lies within the lens’s valid radius.
geometry-heights-not-numbers = The reference height and the board’s uncertainties must be numbers, in metres and radians, the uncertainties not negative.
geometry-row-height-implausible = A reference row { $height_m } m above the road is not plausible; give the height of the { $side } row of inner corners above the road in metres.
geometry-board-moves = The board or the camera moves during these frames (by up to { NUMBER($moved_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px); choose frames, or a single frame, in which both are at rest.
geometry-corners-misfit = The corners do not fit the camera model (residual { NUMBER($rms, minimumFractionDigits: 1, maximumFractionDigits: 1) } px); the camera file belongs to another camera or zoom, or the board is bent.
geometry-board-edge-on = The board is seen edge-on; turn it towards the camera by at least 10 degrees.
geometry-board-lies-flat = The board seems to lie on the road; stand it perpendicular to the road, with its rows level, or measure the height of the row of corners that you named.
geometry-camera-below-road = The reference height of { $height_m } m puts the camera below the road; give the height of the { $side } row of inner corners above the road, in metres.
geometry-image-range = An image of { $width_px } x { $height_px } px is out of range; give a width and a height from 16 to 16384.
geometry-view-range = A horizontal field of view of { $degrees } degrees is out of range; give 5 to 150.
geometry-plan-range = A { $what } of { $value } { $unit } is out of range; give { $least } to { $most }.

## Errors: audit

audit-signing-key-unreadable = { $path } contains no signing key (64 hexadecimal digits); put it back from a backup.
audit-signing-key-another = This machine’s signing key is not the one that the database was signed with; if changing it was interrupted, run `sightline checkpoint`, else put signing.key back from a backup, or give all machines the same SIGHTLINE_SIGNING_KEY.
audit-other-version = This database was made by another version; verify it with that version, or open it once with this one (`sightline serve`), which updates it.
audit-guard-missing = The database no longer protects { $table }: a trigger that refuses changes is missing or switched off. Restore a backup, or restore the trigger and find out who removed it.
audit-not-a-database = { $name } is not a Sightline database, or its beginning is damaged; name the sightline.db of a data folder, or restore a backup.

## Errors: csv_package

csv_package-event-not-next = audit.csv: event { $number } does not follow from the one before; it was changed.
csv_package-event-not-hashed = audit.csv: event { $number } is not the one that was hashed; it was changed.
csv_package-file-missing = { $path } is missing; get the complete package again.
csv_package-target-is-file = { $target } is a file; name a folder for the package that does not exist yet.
csv_package-target-not-empty = { $target } contains other files; name a folder that is empty or does not exist yet.
csv_package-file-twice = { $place } contains a file twice, so it is not a package; get the complete package again.
csv_package-table-twice = { $path } is in the package twice, so it is unclear which one is valid; get the complete package again.
csv_package-not-an-export = { $place } cannot be read as a package; name its folder or ZIP.
csv_package-parquet-not-paired = { $path } has no counterpart: a package has every table as CSV and as Parquet; get the complete package again.
csv_package-parquet-described-otherwise = { $path } has other columns, units or meanings than datapackage.json describes; it was changed.
csv_package-parquet-not-csv = { $path } differs from { $csv_path }: column { $name }, row { $at }; one was changed.
csv_package-parquet-other-rows = { $path } does not have the rows of { $csv_path }; one was changed.
csv_package-parquet-unreadable = { $path } cannot be read as Parquet; get the complete package again.
csv_package-cell-type = { $path } has a cell that does not have the type stated in datapackage.json; it was changed.
csv_package-csv-form = { $path } is not written as Sightline writes a table (near line { $at }: line ending or quotes differ), so programs might read it differently; get the complete package again.
csv_package-zip-odd-entry = { $place } contains { $path }, which is not a plain file of a package; get the complete package again.
csv_package-zip-bomb = { $place }: { $path } would unpack to far more than any table has; get the complete package again.
csv_package-too-many-files = { $place } lists more files than a package can have; get the complete package again.
csv_package-link = { $path } is a link, not a file (or a pipe or device): a package has none; get the complete package again.
csv_package-no-json = { $path } cannot be read as JSON: it was cut off or changed after the export; get the complete package again.
csv_package-zip-encrypted = { $place } is protected with a password; unpack it with the password and give the folder.
csv_package-json-form = { $path } is not written as Sightline writes JSON (a key twice, other blanks or numbers), so programs might read it differently; get the complete package again.
csv_package-columns-differ = { $path } has other columns than datapackage.json describes ({ $column }): it was changed after the export.
csv_package-not-csv = { $path } cannot be read as CSV; get the complete package again.
csv_package-not-unpackable = { $path } cannot be unpacked; get the complete package again.
csv_package-not-as-described = { $path } cannot be read as it was described; get the complete package again.
csv_package-row-length = { $path } has a row that is too long or too short; it was changed.
csv_package-without-event = { $path }: { $kind_name } { $odd } has no audit event, or is missing.
csv_package-twice-one-put = { $path }: { $columns } { $values } appears twice; one was added.
csv_package-event-differs = { $path } differs from its audit event; it was changed.
csv_package-chain-file-changed = { $path_of } is not the one recorded in the audit chain; it was changed.
csv_package-author-or-time = { $path }: { $kind_name } { $id } has another author or time than { $path_2 } states.
csv_package-differs-one-changed = { $path }: { $kind_name } { $id } differs from { $path_2 }; one was changed.
csv_package-row-without-event = { $path }: row { $key } has no audit event; it was added.
csv_package-row-differs = { $path }: { $name } of row { $key } differs from its audit events; it was changed.
csv_package-row-missing = { $path }: row { $key } is missing, although it has an audit event.
csv_package-row-dangling = { $path }: { $mine } { $values } is not in { $table }.csv; a row was removed or changed.

## Errors: database

database-not-supported = A { $backend } database is not supported; use sqlite:///FILE or postgresql+psycopg://USER@HOST/NAME.
database-no-answer = The database does not answer; check that it is running and that its address is right.
database-in-memory = An in-memory database would be lost; name a file, as in sqlite:///sightline.db.
database-disk-full = The disk is full, so nothing was saved; free some space and try again.
database-busy = The database is busy with another writer; try again in a moment.
database-not-writable = The database file cannot be opened for writing; check the folder’s permissions.
database-address-unreadable = The database address cannot be read; use sqlite:///FILE or postgresql+psycopg://.
database-missing = There is no database { $path }; check its name.
database-not-a-database = This file is not a Sightline database, or its beginning is damaged; give the right file, or restore a backup.
database-damaged = The database is damaged: parts of its file contain other data. Stop the server, keep a copy of the data folder, and restore the last backup (sightline restore).
database-read-only-log = { $path } cannot be written, and its last changes are still in the file beside it that ends in -wal; copy the folder to a disk that can be written, and give that.
database-damaged-tables = The database is damaged in { $tables }; its { $whole } other tables can be read. Stop the server, keep a copy of the data folder, and restore the last backup (sightline restore).
database-account-lacks-rights = The database’s account lacks a right that this needs; run `sightline migrate` with the account that owns the tables.
database-no-migrations = There are no migrations in { $folder }; set SIGHTLINE_MIGRATIONS to the folder that has them.
database-newer-version = The database was made by a newer version; update this one before opening it.
database-row-missing = There is no { $word }{ $number }; it may have been removed. Go back and choose another.

## Errors: jobs

jobs-not-yours = Another person started this job; ask them or an operator to cancel it.
jobs-not-to-be-cancelled = This job deletes files that nothing needs any more and cannot be cancelled; let it run.
jobs-kind-unknown = This worker knows no job of kind { $kind_name }; start one of this version.
jobs-other-worker = Job { $id } went to another worker; this one stops.
jobs-already-over = Job { $job_id } is already { $state }, so there is nothing to cancel.
jobs-changed-meanwhile = The state of job { $id } has changed meanwhile; there is nothing to do.
jobs-given-away = Job { $id } was given to another worker; this one stops.

## Errors: web

web-disk-not-writable = The data folder cannot be written ({ $why }); check the disk and the permissions.
web-part-silent = No answer for { $seconds } s; check that it is running and can be reached.
web-writer-stuck = A change has been running for { $seconds } s and blocks the others; check the database.
web-secret-weak = SIGHTLINE_SECRET can be guessed; use at least { $characters } random characters that are published nowhere (openssl rand -hex 32).
web-signing-key-missing = SIGHTLINE_SIGNING_KEY is not set, so each machine would sign with a key of its own; set the same 64 hexadecimal digits on all of them (openssl rand -hex 32).
infra-setting-differs = { $name } differs from the value of the other processes on this database; use the same value for all of them, or stop the others first.
infra-clocks-apart = This machine’s clock and the database’s are { $minutes } minutes apart; synchronise both with a time server (NTP) and start again.
web-server-busy = The server is busy and nothing was done; try again in a few seconds.
web-not-signed-in = You are not signed in; sign in and try again.
web-token-invalid = This token is not valid: it is wrong, has expired or was revoked. Create a new one in Account.
web-token-lacks-scope = This token has the scopes { $scopes }; this needs { $needed }. Create a token with that scope in Account.
web-token-never = Tokens cannot do this; sign in in the browser and do it there.
web-token-requests-many = More than { NUMBER($most) } requests within a minute with this token; wait a minute.
members-last-manager = A survey needs a manager; make another member manager first.
audit-checkpoint-none = This checkpoint does not exist: choose one from the list on the System page.
web-needs-role = This needs the role { $needed }; your role is { $role }. Ask an administrator.
web-too-large = { $name } is larger than { $most_bytes } MB; make it smaller and try again.

## Errors: linescan

linescan-strips-too-low = The strips are { $rows } rows high; at least 8 are needed to find a vehicle.
linescan-strips-differ = The strips differ: { $shape } and { $shape_2 } lines by rows, { $rows } rows expected; both cameras must record the same lines.
linescan-cannot-used-give = { $name } of { $value } { $unit } is out of range; give { $least } to { $most } { $unit }.
line-pose-mark-incomplete = Each mark needs a distance, a height and a row.
line-pose-not-numbers = Distances, heights and rows of the marks must be numbers.
line-pose-too-few = { NUMBER($count) } marks are too few; click at least { $least }.
line-pose-above-zero = Distances of marks and the u of their rows must be above 0.
line-pose-upside-down = Higher marks must have smaller rows; check which end of the rod is up.
line-pose-open = The marks do not determine the camera height: hold the rod upright at two distances, such as the near and the far edge of the lane.
line-pose-below-road = The marks put the camera below the road; check their distances, heights and rows.
line-pose-one-distance = All marks are at one distance, so the camera height cannot be determined; hold the rod upright at two.
line-pose-wide = The marks fit the model to { $rms_px } px only, worse than clicks of { $sigma_px } px explain; check the distances and the mark with the largest residual.
line-pose-vague = The camera’s height is known to { $u_height } m only; hold the rod at two distances further apart, or measure them better.
rig-pass-no-way = It has neither positions nor lines; give the values of one method.
rig-pass-two-ways = It has values of two methods ({ $one } and { $two }); use a row of its own for each.
rig-pass-lacks = The value { $column } is missing; fill it in.
rig-pass-no-rate = Its speed needs the line rate of the cameras; give it.
rig-pass-no-order = The board’s lines are not in order: its front passes each camera before its rear, and both cameras see the same edge first.
rig-pass-stopped = The board stopped or nearly stopped between the planes; carry it through evenly.
rig-pass-span = It gives a baseline of { $span_m } m, outside the range of { $least } to { $most } m; correct its values.
rig-pass-value = The value { $column } is out of range: { $value }; correct it.
rig-passes-differ = The passes differ by more than their uncertainties explain (p = { $chance } %); check pass { $name } first.
rig-passes-too-wide = The passes agree better than their stated uncertainties; these may be too large.
rig-passes-two-distances = Two distances cannot test whether the baseline changes linearly; add a third.
rig-passes-outside = { NUMBER($distance_m, minimumFractionDigits: 2) } m is far outside the passes ({ NUMBER($nearest_m, minimumFractionDigits: 2) } to { NUMBER($farthest_m, minimumFractionDigits: 2) } m), so the baseline there is extrapolated; add a pass at this distance.
rig-pass-twice = Another row has the same name; name each pass once.
linescan-rig-pass = Pass { $name }: { $sentence }
linescan-rig-common = Uncertainties of line rate, tape and speed are relative, from 0 to 0.1 (1e-4 is 0.01 %); correct them.
linescan-lane-needs-name = A lane has no name; give it one.
linescan-lanes-same-name = Two lanes are called { $name }, or a name begins or ends with a space; give each a name of its own.
linescan-lane-rows-both = The lane { $name } has only one row of its tyres; give both, or neither.
linescan-lane-rows-order = The rows of the lane { $name } are not in order; give the upper one first, 0 or more.
linescan-divergence-without-distance = A divergence needs the distance to the vehicles; give it, or leave out the divergence and its uncertainty.
linescan-planes-cross = With this divergence the scanning planes cross in front of the vehicles, which are { $distance_m } m away; correct the baseline, the divergence or the distance.
linescan-planes-too-near = With this divergence the scanning planes are { $baseline_m } m apart at { $distance_m } m; at least { $least_m } m are needed.
linescan-rig-few-passes = { NUMBER($count) } usable passes are too few for baseline and divergence; at least { $least } are needed, at two distances or more.
linescan-rig-distances-alike = All passes are between { $nearest_m } and { $farthest_m } m away, too close to separate the baseline from the divergence; add passes at another distance, for example in the near and the far lane.
linescan-width-two-u = The board of { $width_m } m has two different uncertainties of its width; give the same in every row.
linescan-distance-two-u = The distance of { $distance_m } m has two different uncertainties; give the same in every row of this position.
linescan-rig-contradict = The passes contradict each other (chi-square { $chi2 } with { $degrees ->
    [one] 1 degree
   *[other] { NUMBER($degrees) } degrees
 } of freedom): pass { $name } differs from the others by { $residual_mm } mm, where { $expected_mm } mm (U95) was expected. Measure it again, leave it out, or state larger uncertainties.
rig-passes-too-many = { $name } has more than { $most } rows; give the passes of one calibration alone.
rig-passes-columns = { $name } lacks columns; give distance_m and all columns of one method: { $ways }.
rig-passes-problem = { $path }: { $message }{ $left }
rig-no-lane = --distance { $text } is not a distance to a lane; give it in metres, and after a comma its u, such as 4.2 or 4.2,0.1.
commands-option-above-zero = { $option } must be a finite number above 0; correct it.

## Errors: measurements

measurements-vehicle-other-recording = The vehicle does not belong to this recording; choose one of its passes.
measurements-frame-twice = Frame { $twice } is clicked twice; click the two points on another frame of the pass.
measurements-point-outside = The { $word } point { $point }, { $point_2 } is not in any image; click again.
measurements-no-pose = { $name } has no camera pose yet; compute or choose one on the page Road first.
measurements-pose-image-size = The camera pose of { $name } is for images of { $size_px } x { $size_px_2 } px, not for its own size; compute or choose another one on the page Road.
measurements-frame-cannot-split = Frame { $frame } cannot split vehicle { $number }; go to a frame after its first ({ $first_frame }) and up to its last ({ $last_frame }).
measurements-join-other-recording = Only passes of the same recording can be joined; choose another one.
measurements-join-both-measured = Vehicles { $number } and { $number_2 } both have measurements, and a measurement stays with its vehicle; discard one of the passes instead.
measurements-split-between = Vehicle { $number } was measured before and after frame { $frame }, and a measurement stays with its vehicle; split at another frame.
measurements-withdrawn = This measurement is withdrawn; restore it before you change it.
measurements-repeat-fixed = A repeat cannot be changed; withdraw it and click it again.
measurements-withdrawn-already = This measurement is already withdrawn; restore it to use it again.
adjusting-changed-meanwhile = The adjustment has changed since it was shown; check it again.
adjusting-nothing-in-force = This is not a current adjusted pose, so there is nothing to undo.
computing-undo-of-undo = An undo cannot be undone; compute the heights again instead.
computing-undone-already = This was already undone; compute the heights again to restore them.
computing-undo-later-first = Heights were computed again at { $when }; undo that first.
computing-revision-count = computings.csv: { $id } made a different number of revisions than it states; get the complete package again.
computing-mark-wrong = { $path }: the out-of-date mark of { $id } does not follow from its facts; get the complete package again.
computing-verdict-went-over = revisions.csv: revision { $revision } of measurement { $name } has a verdict that was given to another height; get the complete package again.
measurements-not-withdrawn = This measurement is not withdrawn, so there is nothing to restore.
measurements-vehicle-deleted = { $name } deleted vehicle { $vehicle_number } at { $when }; restore it first.
measurements-changed-meanwhile = { $name } changed this measurement at { $created_at } UTC; reload it.
measurements-repeat-mismatch = A repeat needs the vehicle and the target of the measurement that it repeats.
measurements-pose-other-survey = Camera pose { $pose_id } belongs to another survey; choose one of this survey’s.
measurements-empty-without-reason = A measurement without a height needs a reason; compute it again.
measurements-no-height-reason = A measurement without a height needs a reason; compute it again.
measurements-other-vehicle = This measurement was already stored for another vehicle; click again.
measurements-frame-not-clicked = Frame { $frame } is not the image that was clicked on; load it again.
measurements-status-differs = { $name } states { $status }, its clicks give { $status_2 }; one is wrong.
measurements-words-differ = { $name }: { $column } does not match the code beside it; one was changed.
measurements-revision-without-event = { $path }: measurement { $key } has no audit event for revision { $key_2 }; it was added.
measurements-event-differs = { $path }: measurement { $key } differs from its audit event; it was changed.
measurements-drift-differs = { $name }: the last warning is not what the camera’s movement and the clicks give: { $computed }
measurements-no-revisions = revisions.csv: measurement { $id } has no revisions; one was removed.
measurements-pose-missing = { $path } is missing or is not a camera pose; get the complete package again.
measurements-result-differs = { $name } states { $words } { $told }, its clicks give { $computed }; one is wrong.
measurements-last-revision-differs = measurements.csv: { $id } has another { $column } than its last revision.
measurements-value-differs = { $path }: { $id } has another { $name } than measurements.csv; one is wrong.
measurements-operator-differs = measurements.csv: the operator of { $id } is not who made the first revision with its points (revisions.csv); one is wrong.
measurements-clicked-at-differs = measurements.csv: clicked_at of { $id } is not when the first revision with its points was stored (revisions.csv); one is wrong.
measurements-vehicle-differs = { $path }: { $id } has another { $name } than its vehicle in vehicles.csv; one is wrong.
measurements-vehicle-missing = { $path }: the vehicle of { $id } is not in vehicles.csv; a row was removed.
measurements-row-misplaced = { $path }: { $name } is not where it belongs; a row was removed or added.
measurements-row-added = { $path }: { $row } is not in measurements.csv; it was added.
measurements-u95-wrong = measurements.csv: { $id } has a U95 that is not 1.96 u; one is wrong.
measurements-budget-sum = budget.csv: the contributions to { $id } give { NUMBER($total, minimumFractionDigits: 6, maximumFractionDigits: 6) } m, measurements.csv states { NUMBER($told, minimumFractionDigits: 6, maximumFractionDigits: 6) } m; one is wrong.
measurements-budget-differs = budget.csv: the contributions to { $id } differ from its audit event; one was changed.
cameras-calibration-images-changed = calibrations.csv: { $id } names other images than its audit events; get the complete package again.
measurements-event-another-row = audit.csv: an event of measurement { $id } contains another row than it hashed; it was changed.
measurements-events-two-frames = audit.csv: two events describe frame { $frame } of recording { $recording } differently; one was changed.
measurements-frame-time = vehicles.csv: frame { $frame } of recording { $recording } has a time that does not fit the frames around it; it was changed.
measurements-frame-table-differs = frames.csv: frame { $frame } of recording { $recording } differs from the audit events of its measurements; it was changed.
measurements-frame-differs = { $path }: { $id } was clicked on another frame than frames.csv states; one is wrong.

## Errors: media

media-import-cancelled = The import of { $name } was cancelled; nothing was kept.
media-image-too-large = { $name } states { $width } x { $height } pixels, more than { $max_side_px } on a side or { $max_pixels } million in all; make it smaller and try again.
media-not-decodable = { $name } is damaged and cannot be decoded; save it as PNG or JPEG and try again.
media-empty-choose-picture = { $name } is empty; choose an image.
media-heif-picture = { $name } is a HEIC or AVIF image, which cannot be read here; save it as PNG or JPEG and try again.
media-not-an-image = { $name } is not an image that can be read here; save it as PNG or JPEG and try again.
media-header-damaged = { $name } is damaged: its header does not state its size; save it as PNG or JPEG and try again.
media-not-encodable = An image of shape { $shape } could not be encoded as { $suffix }.
media-file-too-large = { $name } is larger than { $max_bytes } MB; make it smaller.
media-unreadable = { $name } cannot be read ({ $strerror }); check the path.

## Errors: store

store-address-form = { $media_url } is not a media address; use a folder, file:///folder or s3://bucket.
store-no-room = There is not enough space ({ NUMBER($needed_mb, maximumFractionDigits: 1) } MB needed, { NUMBER($free_mb, maximumFractionDigits: 1) } MB free); delete recordings that are no longer needed or add disk space, then try again.
store-no-media-file = There is no media file { $key }.
store-no-cache = Storage on S3 needs a local cache folder; name one beside the media address.
store-file-lost = The media file { $key } is missing from the store; restore it from a backup.
store-no-answer = The media storage did not answer for { $key } ({ $name }); check its address, its credentials and that it is running.
store-no-bucket = { $url } names no bucket; write s3://bucket/prefix.
store-bucket-missing = There is no bucket { $bucket }, and it cannot be created ({ $why }); create it, or name another in SIGHTLINE_MEDIA_URL.
store-file-missing = The media file { $key } is missing from the store.
store-no-upload = There is no such upload; it was finished or cancelled. Start it again.
store-file-empty = The file is empty; choose a video file.
store-upload-incomplete = The upload is not complete: { NUMBER($have) } of { NUMBER($size) } bytes have arrived; continue it.
store-upload-offset = The upload is at byte { $have }, not { $at }; continue from there.
store-upload-name-taken = An upload with this name is already under way; start a new one.
store-upload-busy = Another connection is writing this upload; try again.
store-upload-superseded = This upload continues over a newer connection; this one has ended.
store-upload-too-long = More bytes arrived than the { NUMBER($size) } announced; start the upload again.

## Errors: strips

strips-notes-not-object = { $what } are not a JSON object; correct them.
strips-rate-not-positive = { $what } give a line_rate_hz that is not a positive number; correct it.
strips-dropped-lines-form = { $what } give dropped_lines that are not a list of [line, count] in order; correct them.
strips-notes-too-large = { $what } are larger than { $sidecar_bytes } MB; correct or remove that file.
strips-notes-not-json = { $what } are not readable JSON; correct or remove that file.
strips-header-cut-off = { $name } is cut off in its header; copy it again from the recorder.
strips-in-colour = { $name } is in colour, and a line scan is grey; { strips-save-grey }.
strips-transparency = { $name } has a transparency channel, and a line scan has none; { strips-save-grey }.
strips-colour-with-transparency = { $name } is in colour with transparency, and a line scan is grey; { strips-save-grey }.
strips-save-grey = save it as 8-bit or 16-bit greyscale and try again
strips-copy-again = copy it again from the recorder
strips-give-one-strip = give one camera’s strip
strips-say-time-axis = if time runs along its { $axis }, choose that time axis
strips-bits-pixel = { $name } has { $depth } bits per pixel; { strips-save-grey }.
strips-interlaced = { $name } is interlaced and cannot be read in pieces; save it without interlacing.
strips-png-too-wide = { $name } is { $width_px } pixels wide, more than a PNG may have here ({ $most_wide_px }); save it as TIFF or with time along the height.
strips-checksum-wrong = { $name } is damaged: a checksum inside does not match; copy it again from the recorder.
strips-not-plain = { $name } is not a plain image (an animation, or damaged); { strips-save-grey }.
strips-not-an-image = { $name } { media-kind }; give a PNG or TIFF of the line-scan camera.
strips-heights-differ = { $name } has { $rows } pixels per line and { $name_2 } { $rows_2 }; give two strips of equal height, or crop them to the part of the scene that both show.
strips-bits-differ = { $name } has { $value } bits per pixel and { $name_2 } { $value_2 }; save both alike.
strips-lines-differ = { $name } has { NUMBER($lines) } lines and { $name_2 } { NUMBER($lines_2) }; both must begin and end together, so give the two strips of one recording, or crop them to the same time.
strips-not-a-file = { $name } is not a file; give a PNG or TIFF of the line-scan camera.
strips-jpeg = { $name } is a JPEG, which changes the pixels; save it as PNG or TIFF in the recorder.
strips-lines-too-wide = { $name } would have { $rows } pixels per line with time along its { $time_axis }, more than { $most_rows }; { $hint }.
strips-time-axis-wrong = { $name } has { NUMBER($lines) } lines of { $rows } pixels with time along its { $time_axis }, which shows no vehicle; give a PNG or TIFF of the line-scan camera.
strips-too-many-lines = { $name } has more than { $most_lines } thousand million lines; split it into parts.
strips-lost-lines-many = { $name }: its notes state that { NUMBER($lost) } of { NUMBER($lines) } lines were lost; record it again.
strips-lost-lines-outside = { $name }: its notes state lost lines at { $line }, but it ends at { $lines }; correct them.
strips-unreadable = { $name } cannot be read ({ $strerror }); give a PNG or TIFF of the line-scan camera.
strips-cut-off = { $name } is cut off: it ends in row { $row } of { $height }; copy it again from the recorder.
strips-row-damaged = { $name } is damaged at row { $row } of { $height } and cannot be read further; copy it again from the recorder.
strips-size-impossible = { $name } states an image of { $width } x { $height } pixels; copy it again from the recorder.
strips-size-over-file = { $name } states { $width } x { $height } pixels, more than { $file_bytes } MB of file can hold; it is damaged or not a recording: copy it again from the recorder.
strips-rows-too-long = { $name } has rows of { $width_px } pixels, too long to be read; copy it again from the recorder.
strips-stored-damaged = The stored strip { $name } is damaged; restore it from a backup or read it again.
strips-stored-missing = The stored strip { $name } is missing; restore it from a backup.
strips-spool-damaged = { $path } is not a strip of a stream, or is damaged; leave it, and choose another --spool.
strips-no-level = The strip { $name } has no level { $level }, only 0 to { $last }.
strips-gain-range = A gain of { $gain } is out of range; choose 0.1 to 50.
strips-no-tile = The strip { $name } has no tile { $index } in level { $level }.
strips-index-size = has a pixel index that does not fit its size; { strips-copy-again }
strips-several-images = { $name } contains several images; give each strip as one long image.
strips-palette = { $name } has a palette, and a line scan is grey; { strips-save-grey }.
strips-not-grey = { $name } is in colour or has a transparency channel, a line scan is grey; { strips-save-grey }.
strips-number-kind = { $name } contains signed or floating-point numbers; { strips-save-grey }.
strips-bits-pixel-2 = { $name } has { $bitspersample } bits per pixel; { strips-save-grey }.
strips-packing-unsupported = { $name } is compressed with { $kind_name }, which is not supported; save it with zstd, deflate or LZW compression, or with none.
strips-packing-unusual = { $name } is compressed in an unusual way; save it with zstd, deflate or LZW compression, or with none.
strips-not-upright = { $name } is marked as rotated or mirrored; save it upright.
strips-tiff-cut-off = { $name } is a TIFF that is cut off or whose directory is damaged; { strips-copy-again }.
strips-pieces-too-large = { $name } is compressed in pieces of more than { $piece_bytes } MB; save it in smaller strips or tiles.
strips-tiles-too-large = { $name } has rows of tiles of more than { $piece_bytes } MB; save it in smaller tiles.
strips-problem-2 = { $name } { $message }.
strips-tiff-damaged = { $name } is a TIFF whose directory is damaged; { strips-copy-again }.
strips-too-few-frames = { $name } has { NUMBER($count) } frames, too few for a line scan; choose another recording.
strips-rate-uneven = { $name } has no constant frame rate (its time stamps are uneven, most of all after frame { $at }), and a line scan needs one; cut out an even part, or record with a fixed frame rate.
strips-cuts-unusable = The { $what ->
    [rows] rows
   *[columns] columns
} { $cut_1 } and { $cut_2 } cannot be cut from { $name }; choose two different ones from 0 to { $last_px }.
strips-frames-changed = { $name } now has { NUMBER($count) } frames, not { NUMBER($count_2) }; import it again.

## Errors: video

video-not-a-file = { $name } is not a file; choose a video file.
video-is-no-video = { $name } { media-kind }, not a video; choose a video file.
video-is-empty = { $name } { media-kind }; choose a video file.
video-is-cut-off = { $name } { media-kind }; copy it again from the recorder, or repair it there.
video-this-recording = This recording
video-not-decoded-at = This recording cannot be decoded at frame { $frame }: the decoder { $why } there; convert the recording to MP4 with H.264 and upload it again.
video-too-large-at = This recording cannot be decoded at frame { $frame }: the decoder { $why } there; convert the recording to smaller frames and upload it again.
video-decoder-memory = needed more than { $gigabytes } GB of memory, alone in a fresh process,
video-decoder-hung = hung
video-decoder-killed = was killed again and again, also alone in a fresh process,
video-decoder-crashed = crashed
video-decoder-ended = ended
video-decoder-silent = made no progress for { $seconds } s
passes-camera-moves = The camera moves by up to { $far_px } px; the search compensates for it. A camera pose is valid only while the camera is at rest.
passes-camera-moves-too-far = The camera moves (by { $far_px } px and more), so road and vehicles cannot be separated; mark the passes by hand.
passes-were-found = { $found ->
    [0] No passes were found; mark them by hand.
    [one] 1 pass was found.
   *[other] { NUMBER($found) } passes were found.
}
passes-were-found-again = { $found ->
    [one] 1 pass was found
   *[other] { NUMBER($found) } passes were found
}: { $new ->
    [0] none new
   *[other] { NUMBER($new) } new
}, { NUMBER($known) } known or discarded before.
scan-vehicles-found = { NUMBER($found) } found, { NUMBER($added) } new, { NUMBER($revised) } measured again.
scan-vehicles-left = { NUMBER($count) } unchanged because another user edited them meanwhile.
media-kind = { $kind ->
    [empty] is empty
    [playlist] is a playlist that points to other files
    [png] is a PNG image
    [jpeg] is a JPEG image
    [gif] is a GIF image
    [bmp] is a BMP image
    [tiff] is a TIFF image
    [webp] is a WebP image
    [heif] is a HEIF or AVIF image
    [zip] is a zip archive
    [pdf] is a PDF document
    [gzip] is a gzip archive
    [rar] is a RAR archive
    [seven_zip] is a 7z archive
    [audio] is an audio file
    [ogg] is an Ogg file, which is not supported
    [text] is a text file
    [cut_before_index] is cut off before its index (moov) was written
    [cut_in_index] is cut off in the middle of its index (moov)
   *[other] is not an image format that is supported
}
video-no-video-track = { $name } contains no video, only sound or data; choose a video file.
video-no-such-stream = { $name } has no video track { $number }; it has { NUMBER($count) }, counted from 1.
video-track-is-still = Video track { $number } of { $name } is a still image; choose another track.
video-stream-is-off = Video track { $number } of { $name } is disabled in the file; choose another track.
video-slowed-in-part = Only part of { $name } is in slow motion, so one filming rate does not give its times; save it with the times of filming.
video-codec-unsupported = { $name } uses a video codec that cannot be decoded here; convert it to MP4 with H.264 or choose another file.
video-size-missing = { $name } does not state its frame size, or states an impossible one; convert it to MP4 with H.264 or choose another file.
video-size-too-large = { $name } states a frame of { $width } x { $height } pixels, more than { $max_side_px } on a side or { $max_pixels } million in all; convert it to MP4 with H.264 or choose another file.
video-aspect-implausible = { $name } states a pixel aspect ratio of { $aspect }, which is not plausible; convert it to MP4 with H.264 or choose another file.
video-not-a-video = { $name } is not a video that can be read here; convert it to MP4 with H.264 or choose another file.
video-no-times-follow = { $name } does not state the times of its frames, so a vehicle cannot be followed in it; convert it to MP4.
video-in-parts = { $name } is put together of several parts by an edit list, so its frame times are not those of filming; export every part as a file of its own.
video-times-not-filming = The time stamps of { $name } are not the times of filming (its notes give the reason), so motion is not measured. Enter its filming rate.
video-no-frame = { $name } contains no frame that can be decoded; convert it to MP4 with H.264 or choose another file.
video-set-aside = This recording crashed the decoder { NUMBER($count) } times and is not tried again; convert it to MP4 with H.264 and upload it again.
video-decoder-failing = The decoder crashed repeatedly; check the memory of this server.
video-not-decodable = { $header } cannot be decoded: the decoder { $why }; save it in another format and try again.
video-frame-unwanted = This frame is no longer needed.
video-frame-outside = There is no frame { $n }; this recording has frames 0 to { $last }.
video-crop-outside = A crop of { $w } x { $h } pixels at scale { $scale } is out of bounds; ask for a smaller one.
video-no-frame-readable = { $name } contains no frame that can be decoded; copy it again or convert it to MP4.
video-size-changes = { $name } changes its frame size partway; split it there.
video-proposals-cancelled = Suggesting points for { $name } was cancelled; nothing was kept.
video-search-cancelled = The search for passes in { $name } was cancelled; nothing was kept.
video-not-addressable = The frames of { $name } cannot be addressed one by one; convert it to MP4 with H.264 and try again.
video-disk-full = The disk is full and { $name } was not imported; free some space and try again.
video-frame-changed = Frame { $n } cannot be shown: the stored video no longer gives the frame whose checksum was recorded at import; restore the file from a backup or import it as a new recording.
video-stored-missing = The stored video { $name } is missing or can no longer be opened; restore it from a backup.
video-numbered-frame-unwanted = Frame { $n } is no longer needed.
video-frame-form = { $name } needs BGR frames of one even size, got { $shape } for { $width } x { $height }.
video-no-frames-written = { $name } cannot be written without frames.

## Errors: people

people-sign-in-wrong = Wrong e-mail or password. Try again.
people-password-length = A password has { $min_password } to { $max_password } characters; choose another.
people-sign-ins-slowed = Many sign-ins from your network failed; try again in { $seconds } s.
people-password-one-sign = A password has at least { $least } different characters besides spaces; choose another.
people-password-wrong = The current password is wrong; enter it again.
people-no-account = There is no active account for { $email }; check the address.
people-sign-ins-blocked = Too many failed sign-ins; wait five minutes and try again.
people-token-incomplete = A token needs a name, a scope and 1 to { NUMBER($most_days) } days; fill them in.
people-token-too-many = You already have { NUMBER($most) } tokens; revoke one that is no longer used.
people-link-used = This sign-in link was already used or has expired; ask an administrator for a new one.
people-link-switched-off = { $person }’s account is deactivated; reactivate it before you make a sign-in link.
people-email-form = “{ $email }” is not an e-mail address; write it as name@place.
people-account-exists = There is already an account for { $email }; change that one instead.
people-last-admin = This is the last administrator; make another person administrator first.
people-no-name = A person needs a name; fill it in.
people-role-unknown = There is no role “{ $role }”; use one of { $roles }.

## Errors: poses

poses-frames-outside = Frames { $first_frame } to { $last_frame } are not in { $name }; it has frames 0 to { $frame_count }.
poses-board-not-shown = Frames { $first } to { $last }: { $reason }
poses-calibration-image-size = The calibration is for images of { $width_px } x { $height_px } px and { $name } has { $width_px_2 } x { $height_px_2 } px; choose a calibration made at the recording’s size.
poses-calibration-other-survey = Calibration { $calibration_id } belongs to another survey; choose one of this survey’s.

## Errors: quality

quality-pose-unused = No recording uses this camera pose any more; reload the page Checks.
quality-direction-changed = The travel direction is now { $turn_deg }°, not the value shown; reload the page.
quality-frame-outside-pass = Vehicle { $number } does not appear in frame { $frame }; it passes in frames { $first_frame } to { $last_frame }. Go to one of them.
quality-repeats-too-few = { $name } has repeated { $pairs } of their own measurements; { $least_pairs } are needed for their own click uncertainty. Repeat more of them.

## Errors: recordings

recordings-too-few-images = { $name } has { $images } images; add at least three, preferably 15 to 25.
recordings-other-survey = { $name } belongs to another survey; choose one of this survey’s.
recordings-no-pose = { $name } has no camera pose yet, so the position of its camera is unknown.
recordings-not-ready = { $name } is still being imported; wait until it is ready.
recordings-import-failed = { $name } could not be imported, so it has no frames; see its error and try again.
recordings-frame-table-incomplete = The frame table of { $name } is incomplete; import the recording again.
recordings-frame-outside = Recording { $recording_id } has no frame { $n }; choose one within the recording.
recordings-no-thumbnail = Frame { $n } of { $name } has no thumbnail; ask for the frame itself.
recordings-importing-already = { $name } is already being imported; wait for it or cancel it.
recordings-import-cancelled = The import was cancelled; start it again or delete the recording.
recordings-importing = { $name } is being imported; cancel that first.
recordings-times-are-filming = The time stamps of { $name } are the times of filming; no filming rate is needed.
recordings-rate-in-use = Measurements or line scans already use the filming rate of { $name }; to use another rate, upload the file again.
recordings-picture-is-there = Video track { $number } is already in this survey, as { $name }.
recordings-field-unknown = A recording’s { $unknown } cannot be changed; leave it out.
recordings-no-name = A recording needs a name; fill it in.
recordings-street-lighting-unknown = Street lighting was either on or off; choose one.
recordings-start-in-future = { $start } in { $zone } is in the future; enter the time at which the recording began.
recordings-start-too-early = There was no digital video on { $start }; enter the day on which the recording began.
recordings-misfit-size = Its frames are { $width } x { $height } px, but its camera’s calibration is for { $lens_width } x { $lens_height } px: record at the calibrated size, or calibrate at this one.
recordings-misfit-focal = Its file states a focal length of { $stated_mm } mm (35 mm equivalent), but its camera’s calibration gives about { $lens_mm } mm: check the zoom.
recordings-misfit-lamps = Its street lighting was on, but the survey states that the road has none: correct one of the two.
local-time-unknown-zone = { $zone } is not a time zone of the IANA list; choose one such as Europe/Paris.
local-time-cannot-read = { $text } cannot be read as a time; write it as 2026-05-03T08:10:00.
local-time-skipped = { $time } does not exist in { $zone }, where clocks were set forward; enter the time that they showed ({ $before } before the change, { $after } after it).
local-time-twice = { $time } occurs twice in { $zone }, where clocks were set back; choose the first ({ $first }) or the second ({ $second }).
local-time-other-offset = At { $time } clocks in { $zone } have the offset { $offset }; give that offset or none.
measurements-filmed-time = measurements.csv: { $id } has another time of filming than its recording’s start gives; one of them was changed.
measurements-state-differs = vehicles.csv: { $id } is { $told }, its measurements make it { $state }; one of them was changed.
measurements-vehicle-time = vehicles.csv: { $id } has another time of filming than its recording’s start gives; one of them was changed.
recordings-lighting-unknown = The lighting is daytime or low_light; choose one.
recordings-measured = This recording has measurements and cannot be deleted: an audit needs its frames.
recordings-camera-not-moved = No camera movement was detected since the camera pose; there is nothing to decide.
recordings-pose-without-reason = State why the camera pose is still valid, so that an audit can follow the decision.
recordings-no-decision = There is no decision about this recording’s camera to undo.
recordings-named-other-survey = The { $word } { $row_id } belongs to another survey; choose one of this survey’s.
recordings-pose-image-size = The camera pose { $pose_id } is for images of { $posed } x { $posed_2 } px and { $name } has { $filmed } x { $filmed_2 } px; choose a pose made at the recording’s size.
recordings-frames-differ = The frames found now are not those that were measured; upload the video as a new one.
recordings-tus-version = Uploads use tus 1.0.0; send the header Tus-Resumable: 1.0.0.
recordings-too-many-uploads = You have { $most } uploads that are not complete; finish or cancel some first.
recordings-uploads-no-room = There is not enough space for this upload ({ NUMBER($needed_mb, maximumFractionDigits: 1) } MB) beside your uploads that are not complete ({ NUMBER($to_come_mb, maximumFractionDigits: 1) } MB still to come, { NUMBER($free_mb, maximumFractionDigits: 1) } MB free); finish or cancel some first.
recordings-upload-without-length = The upload does not state the length of the file; send the header Upload-Length.
recordings-upload-content-type = The bytes of an upload come as application/offset+octet-stream; send that Content-Type.
recordings-upload-without-name = The upload does not name its file; send filename in the header Upload-Metadata.
recordings-upload-purpose = The upload’s purpose is video or strip; send one of them in Upload-Metadata.
recordings-upload-metadata = The upload’s { $word } cannot be read; send it as base64 of UTF-8.
recordings-upload-finished = This upload is already finished; look for its recording in the list.
recordings-upload-of-deleted = This upload became a recording that was deleted since; upload it again.
recordings-upload-awaits-scan = This upload is already finished; create the line scan from it.
recordings-upload-is-recording = This upload is finished; delete its recording instead.

## Errors: results

results-cell-unreadable = { $path }: { $name } cannot be read; get the complete package again.
results-word-unknown = The database contains the { $name } “{ $unknown }”, which this version does not know.
results-reference-u = The reference heights’ u must be at least 0 and below 1 m, such as 0.0173.
results-own-values-many = At most { $most_own } values of your own can be shown; remove some.
results-own-value-range = A value of your own must lie between 0 and 10 m, such as 1.08.
results-standards-changed = The standards were changed meanwhile; reload them and repeat your change.
results-standards-many = A table of { NUMBER($count) } standards is too long; { $most } are the maximum.
results-standard-twice = { $twice } appears twice in the table; give each value its own name.
results-standard-no-name = A standard needs a name, such as AASHTO (USA).
results-standard-height = The height of { $name } must lie between 0 and 10 m, such as 1.08.
results-standard-percent = { $name }: a percentile lies above 0 and below 100; correct it, or leave it empty.
results-days-exchanged = The last day is before the first; swap them.
recordings-hours-are-none = The hours begin and end at the same time; choose another end.
results-no-survey = There is no survey { $survey_id }; it may have been removed.

## Errors: reviews

reviews-fix-one-point = A fix needs both points, contact and target; click them and send them along.
reviews-fix-line-scan = A height of a line scan cannot be fixed in Review; reject it, or measure it again under Line scans.
reviews-points-without-fix = Only a fix has points; leave them out or choose the verdict fixed.
reviews-withdrawn = This measurement is withdrawn; there is nothing to review.
reviews-repeat = A repeat is not reviewed; review the measurement that it repeats.
reviews-rejection-no-reason = A rejection needs a reason; state what is wrong so that the operator can correct it.
reviews-fix-without-points = A fix needs the new points, and only a fix has them; click them and send them along.
reviews-plan-changed = The plan was changed meanwhile; reload it and repeat your change.
reviews-plan-range = Enter a number from 0 (no blind checks) to { $most }.
reviews-repeat-first = The survey’s plan requires a blind repeat of this measurement; click contact and target, then give your verdict.
reviews-fix-unchanged = Nothing was changed; move a point, or accept the measurement.
reviews-waits-review-already = This is already waiting for a review.
reviews-own-measurement = You cannot review your own measurement; ask another reviewer.
reviews-verdict-differs = measurements.csv: the verdict on { $one } is not that of its newest review; one is wrong.

## Errors: scans

scans-calibrated-meanwhile = { $name } calibrated this line scan meanwhile; check that calibration first.
scans-mark-outside = A mark at row { NUMBER($row_px, minimumFractionDigits: 1, maximumFractionDigits: 1) }, line { NUMBER($line, minimumFractionDigits: 0, maximumFractionDigits: 0) } lies outside the strip; click it again.
scans-no-pose = Heights need the line camera’s pose; calibrate the height with a rod first (Calibrate height).
scans-side-missing = The driver’s side of this vehicle is not set; choose near or far first.
scans-click-outside = A click at line { NUMBER($line, minimumFractionDigits: 0, maximumFractionDigits: 0) }, row { NUMBER($row, minimumFractionDigits: 1, maximumFractionDigits: 1) } lies outside the strip; click again.
scans-height-no-reason = A target without a height needs a reason; measure it again.
scans-height-withdrawn = This height was already withdrawn; there is nothing to do.
scans-target-measured-meanwhile = { $name } measured this target meanwhile; check that height first.
scans-calibration-no-row = { $path }: calibration { $marks } is in no row of { $path_2 }.
scans-rig-needs-distance = Enter the distance from the cameras to the vehicles: with diverging planes, speeds use the baseline at that distance.
scans-rig-passes-without = { $path }: passes of calibration { $id } exist, but not the calibration itself; a row is missing.
scans-rig-passes-differ = { $path }: the passes of calibration { $id } differ from its audit event.
scans-rig-unsolvable = { $path }: the passes of calibration { $id } give no calibration; one of them is wrong.
scans-rig-differs = { $path }: { $name } of calibration { $id } is not what its passes give.
scans-marks-differ = { $path }: the marks of calibration { $id } differ from its event.
scans-current-not-newest = { $path }: a row marked as current is not the newest revision.
scans-height-no-row = { $path }: height { $budget } is in no row of { $path_2 }.
scans-sources-differ = { $path }: the sources of height { $id } are not those of its clicks.
scans-marks-clicks-give = { $name } has { $column } { $told }, its marks and clicks give { $computed }.
scans-marks-unsolvable = { $name } cannot be solved for from its marks; one is wrong.
scans-no-motion = This vehicle has no measured motion, so there is no registration to show.
scans-second-strip-ends = The strip of camera 2 ends before this vehicle, so there is no registration to show.
scans-upload-twice = Both cameras name the same upload; upload a strip for each.
scans-strips-same = { $name } and { $name_2 } are the same image; give the strip of each camera.
scans-frames-uneven = { $name } has frames at uneven times, and a line scan needs a steady rate; record at a constant frame rate.
scans-cuts-unusable = { $what ->
    [rows] Rows
   *[columns] Columns
} { $cut_1 } and { $cut_2 } cannot be cut; choose two different ones from 0 to { $last_px }.
scans-read-already = { $name } was already imported; there is nothing to do.
scans-import-failed = { $name } could not be imported; see its error and try again.
scans-strips-taken-along = Another recording with the same strips was deleted meanwhile; these are read again.
scans-not-live = No stream is recording { $name }; nothing can be added to it.
scans-live-one-strip = Both strips or none must be given; send the upload that is missing, or neither.
scans-measured-contradicts = The values of the vehicle at line { $line } contradict each other; send them as they were measured.
scans-still-being-recorded = { $name } is still being recorded; its image is available when this part of the stream ends.
scans-not-ready = { $name } is still being imported; wait until it is ready.
scans-already-wait-cancel = { $name } is already { $what ->
    [read] being read
   *[searched] being searched for vehicles
}; wait for that or cancel it.
scans-strip-other-survey = The { $word } strip was uploaded to another survey; upload it to this one.
scans-upload-is-video = { $filename } was uploaded as a video; upload it again as a strip.
scans-upload-used = { $filename } belongs to a line-scan recording already; upload it again.
scans-strip-incomplete = The { $word } strip, { $filename }, has not arrived completely; finish its upload.
scans-changed-meanwhile = { $name } changed { $name_2 } at { $when }; reload it and repeat your change.
scans-field-unknown = A scan’s { $unknown } cannot be changed; leave it out.
scans-start-u-range = An uncertainty of the start of { $u_s } s is out of range; enter a standard uncertainty above 0 and up to 3600 s.
scans-vehicle-time-differs = { $path }: vehicle { $number } has another passing time than its recording’s start and its lines give; one of them was changed.
scans-rig-not-sound = { $path }, row { $id }: the rig cannot be as it stands there (baseline, line rate, lanes or another of its values); get the complete package again.
scans-gap-differs = { $path }: { $name } of vehicle { $number } is not what its motion and the one before it give; one of them was changed.
scans-direction-differs = { $path }: revision { $number } has another direction than its lines at both cameras give; one of them was changed.
scans-axles-without-motion = Axles are counted of a vehicle whose motion is measured; this one has none.
scans-axle-outside-vehicle = An axle lies outside the vehicle; click its hub between front and rear.
scans-traffic-no-start = The start of this line scan is not confirmed. Confirm it to count its traffic by time of day.
scans-traffic-other-minutes = Traffic cannot be counted in intervals of { $minutes } min; choose 1, 5, 15 or 60.
scans-traffic-not-read = This line scan is not imported, so its traffic is unknown.
scans-traffic-other-rate = Vehicles of this line scan were measured with another line rate, so its traffic is unknown. Measure them again.
scans-traffic-overlap = { $others ->
    [0] { $earlier } and { $later } overlap for { NUMBER($seconds) } s: a vehicle that both contain counts in each.
    [one] { $later } overlaps { $earlier } for { NUMBER($seconds) } s and another earlier one: a vehicle that several contain counts in each.
   *[other] { $later } overlaps { $earlier } for { NUMBER($seconds) } s and { NUMBER($others) } other earlier ones: a vehicle that several contain counts in each.
}
scans-no-name = A scan needs a name; fill it in.
scans-worked-on = People have worked on the vehicles of this line scan, so it cannot be deleted: an audit needs its strips.
scans-recording-other-survey = The recording belongs to another survey; choose one of this survey’s.
scans-unread = { $name } has not been imported yet; wait until it is ready.
scans-cameras-worked-on = People have worked on { $name }, so its cameras cannot be swapped; add a line scan with the strips swapped.
scans-vehicle-not-measured = This vehicle is not measured yet, so it has no wheelbase; place its boundaries first.
scans-wheel-outside = A wheel lies outside the strips, which end at line { $lines }.
scans-front-after-rear = At camera { $camera } the front (line { NUMBER($front, minimumFractionDigits: 1, maximumFractionDigits: 1) }) must come before the rear ({ NUMBER($rear, minimumFractionDigits: 1, maximumFractionDigits: 1) }); place them again.
scans-boundaries-outside = The boundaries at camera { $camera } lie outside the strip, which ends at line { $lines }; place them again.
scans-boundaries-far-apart = Front and rear at camera { $camera } are { NUMBER($rear, minimumFractionDigits: 0, maximumFractionDigits: 0) } lines apart, more than a vehicle takes; place them again.
scans-second-camera-blank = Nothing in the strip of camera 2 looks like this vehicle; place its front and rear there by hand, or remove it if it is not a vehicle.
scans-speed-no-reason = A vehicle without a speed needs a reason; measure it again.
scans-vehicle-measured-meanwhile = This vehicle was measured again meanwhile; check the newer result.
scans-own-boundaries = You cannot review boundaries that you placed; ask another reviewer.
scans-second-camera-half = Camera 2 needs both lines, front and rear, or none; send both or leave both out.
scans-wheel-missing = A wheelbase needs both wheels; send both lines, or none to remove them.
scans-vehicle-not-deleted = This vehicle was not deleted, so there is nothing to restore.
scans-vehicle-deleted = { $name } deleted vehicle { $number } at { $when }; restore it first.
scans-vehicle-changed = { $name } changed vehicle { $number } at { $when }; reload it and repeat your change.
scans-vehicle-field-unknown = A scanned vehicle has no { $unknown }; leave it out.
scans-metres-range = A { $name } of { $value } m is out of range; give it in metres, as in 4.447.
scans-vehicle-not-newest = { $path }: vehicle { $number } is not its newest revision; it was changed.
scans-verdict-went-over = { $path }: row { $id } has a verdict that was given to another measurement; get the complete package again.
scans-verdict-differs = { $path }: the verdict of row { $number } is not the one given.

## Errors: statistics

statistics-percentile-range = There is no percentile { $percent }; give one between 0 and 100, such as 10.
statistics-width-not-positive = Width and spread must be lengths above 0, in metres, such as 0.02 and 0.08.

## Errors: surveys

surveys-photograph-missing = The file of the photograph “{ $name }” is missing or was changed; remove it from the survey and add it again.
surveys-photographs-many = A survey has at most { $most_photographs } photographs; remove one before adding another.
surveys-photographs-changed = Photographs were added or removed meanwhile; reload and change the order again.
surveys-photograph-changed = { $name } changed this photograph at { $when }; reload it and repeat your change.
surveys-caption-long = A caption has at most { $most_caption } characters; shorten it.
surveys-no-row-put = { $strange } is in no row of { $path }; it was added.
surveys-photograph-replaced = { $file } is not the photograph named by its audit event; it was replaced.
surveys-no-survey = There is no survey named “{ $name }”; check the name on the home page.
surveys-changed-meanwhile = { $name } changed this survey at { $when }; reload it and repeat your change.
surveys-place-half-coordinates = Coordinates are a latitude and a longitude; give both or neither.
surveys-place-latitude = Latitude { $latitude } is out of range; give −90 to 90 degrees. Are latitude and longitude swapped?
surveys-place-longitude = Longitude { $longitude } is out of range; give −180 to 180 degrees.
surveys-place-speed-limit = A speed limit of { $kmh } km/h is out of range; give a value above 0 and up to { $fastest } km/h.
surveys-no-name = A survey needs a name; fill it in.
surveys-inset-unusable = The inset of “{ $target }” cannot be used; give a known target and an uncertainty of 0 or more.
surveys-asks-nothing = A survey needs at least one target by day and one in low light; choose them.
surveys-sampling-step = Every n-th pass: n must be from 1 to { $most_step }, the first number from 1 to n; correct them.
surveys-sampling-share = A share of the passes must be above 0 and at most 100 %; correct it.
surveys-sampling-headway = The headway of free-flowing vehicles must be above 0 and at most { $most_headway_s } s; correct it.
surveys-sampling-quota-twice = A quota for one lighting and set of classes is given twice; give each once.
surveys-class-twice = The class { $category } is in the table twice; give each class once.
surveys-class-fhwa = An FHWA class of { $category } is not between 1 and 13; correct it.

## Errors: vehicles

vehicles-no-row-used-line = No row of { $name } can be used; line { $line }: { $reason }
csv-too-large = { $name } is larger than { $most_bytes } MB; split it into several files.
vehicles-column-missing = { $name } has no column { $missing }; its first line must name the columns, from { $known }.
vehicles-category-unknown = “{ $category }” is not a category; use one of { $categories }.
vehicles-not-a-year = { $column } is “{ $cell }”, which is not a year; give four digits.
csv-empty = { $name } is empty; its first line must name the columns { $needed }.
csv-no-column = { $name } has no column { $missing }; its first line must name the columns { $needed }.
csv-column-twice = { $name }, line { $line }: the column { $column } is named twice; keep the one that counts.
csv-column-expanded = The column “{ $column }” of { $name } has the capital U or the U95 of an expanded uncertainty; give the standard uncertainty (k = 1) in a column with “u_” in front.
csv-more-cells = { $name }, line { $line } has { $cells } cells, but the header names { $columns }; write decimals with a point, not a comma, and put texts with commas in quotes.
csv-fewer-cells = { $name }, line { $line } has { $cells } cells, but the header names { $columns }; fill in the row.
csv-header-again = { $name }, line { $line } names the columns again, as where tables were put together; leave that line out.
csv-open-quote = { $name }, line { $line }: a quote is not closed on its line; close or remove it, and keep line breaks out of cells.
csv-after-a-quote = { $name }, line { $line }: text follows a closing quote; write a quote within a cell twice, or remove it.
csv-cell-not-closed = { $name }, line { $line } may be the rest of the cell that line { $opened } does not close; correct both lines.
csv-empty-cell = { $name }, line { $line }: { $column } is empty; fill in the cell.
csv-not-a-number = { $name }, line { $line }: { $column } is “{ $cell }”, which is not a number; correct the cell.
csv-number-separated = { $name }, line { $line }: { $column } is “{ $cell }”; write decimals with a point and nothing between thousands.
csv-size-too-large = { $name }, line { $line }: { $column } is “{ $cell }”, and no vehicle has more than 20 m; in { $unit } it would be { $metres } m. Give metres.
csv-size-not-positive = { $name }, line { $line }: { $column } is “{ $cell }”; a size is above 0. Correct the cell.
csv-uncertainty-below-0 = { $name }, line { $line }: { $column } is “{ $cell }”; an uncertainty is not below 0. Correct the cell.
csv-not-utf-8 = { $name } is not a UTF-8 text; save it as CSV in UTF-8.
vehicles-frames-changed = { $name } now has { NUMBER($count) } frames, but had { NUMBER($count_2) } when it was imported; import it again.
vehicles-search-running = Passes of { $name } are already being searched; wait until that has finished.
vehicles-no-frames = A vehicle needs its first and last frame; mark the pass on the timeline.
vehicles-year-to-come = No model of { $year } can have passed yet; give a year up to { $most }.
vehicles-field-unknown = A vehicle has no { $unknown }; leave it out.
vehicles-frames-outside = Frames { $first } to { $last } are not a span of this recording; it ends at frame { $end }.
vehicles-best-frame-outside = The best frame { $best } is outside frames { $first } to { $last }; choose one of them.
vehicles-model-size-unknown = { $size } is not a size of a model; give some of { $known }.
vehicles-model-without-sizes = A model chosen by size needs the sizes that it was chosen by; add model_sizes.
vehicles-no-driver-target = “No driver seen” is a reason for the driver’s eye, not for { $target }; choose another.
vehicles-known-height-range = A known height of { $height } m is out of range; give it in metres, as in 1.624.
vehicles-known-height-kind = A { $target ->
    [roof] roof
    [driver_eye] driver’s eye
    [taillight] taillight
    [headlight] headlight
   *[other] mark
} height of { $height } m is out of range; give { $low } to { $high } m.
vehicles-u-range = An uncertainty of { $u_height } m is out of range; give it in metres, as in 0.005.

## Errors: what the framework refuses, and what was said before

said = { $sentence }
request-needs-header = Requests that change data need the header { $header }; add it and send it again.
request-from-another-site = This request comes from another site and was refused; use Sightline’s own pages.
request-no-json = The request’s body is not valid JSON; send a JSON object.
request-cannot-be-used = The { $place } of the request cannot be used: { $said }; correct it and send it again.
request-value-unusable = The value "{ $name }" of the { $place } cannot be used: { $said }; correct it and send it again.
request-extra = extra inputs are not permitted
request-missing = field required
request-finite = input should be a finite number
request-boolean = input should be a valid boolean
request-integer = input should be a valid integer
request-number = input should be a valid number
request-text = input should be a valid string
request-list = input should be a valid list
request-object = input should be a valid dictionary
request-above = input should be greater than { $gt }
request-least = input should be greater than or equal to { $ge }
request-below = input should be less than { $lt }
request-most = input should be less than or equal to { $le }
request-text-long = string should have at most { $max_length } characters
request-pattern = string should match pattern { $pattern }
request-said = a sentence consists of its code and its values
request-nul = a text cannot contain the NUL character
request-one-of = input should be one of { $expected }
request-date = input should be a valid date, such as 2026-05-04
request-datetime = input should be a valid date and time, such as 2026-05-04T08:10:00
request-time-zone = input should have its time zone, such as 2026-05-04T08:10:00Z
request-list-short = list should have at least { $min_length ->
    [one] { $min_length } item
   *[other] { $min_length } items
}, not { $actual_length }
request-list-long = list should have at most { $max_length ->
    [one] { $max_length } item
   *[other] { $max_length } items
}, not { $actual_length }
request-text-short = string should have at least { $min_length ->
    [one] { $min_length } character
   *[other] { $min_length } characters
}
request-nothing-there = There is nothing at { $path }; check the address.
request-bad-method = { $method } is not possible at { $path }; see /docs for the methods there.
request-refused = { $detail }; correct it and try again.
request-done-before = This request was stored when it was first sent, and its answer is not kept; read what there is now.
request-key-malformed = An Idempotency-Key has 1 to 100 letters, digits, dots, colons or hyphens; send a new UUID for each write.
request-key-of-another = The Idempotency-Key { $key } was sent before with another request; make a new key for each write.
request-value-not-storable = A value in the request cannot be stored; correct it and send it again.
server-something-went-wrong = Something went wrong on the server and nothing was saved; see the server’s log.

## Errors: another person was quicker

quality-tyres-changed-meanwhile = { $name } changed the tyres of this vehicle meanwhile; check them first.
measurements-discard-measured = Vehicle { $number } is measured, so it cannot be discarded; withdraw its measurements first.
measurements-sample-differs = vehicles.csv: whether vehicle { $id } is in the sample and counts does not follow from sampling.csv and the passes; it was changed.
measurements-invisible-measured = { $target } is measured of this vehicle, so it is visible; withdraw the measurement first.
measurements-already-measured = { $name } has measured this target of the vehicle already; keep one of the two.
lots-lead = Measurements can be reviewed in lots: a sample of each lot is reviewed, and the lot is accepted or inspected fully. The plan states the risk of a wrong decision either way. Heights of line scans are reviewed in the queue.
lots-loading = the lots
lots-summary = Accepted measurements: { $individual } individually, { $by_lot } by the sample of their lot.
lots-outgoing = { $count ->
    [one] Of the 1 not reviewed individually, { $estimate } is estimated to be wrong and { $most } at most ({ $share }, one-sided 95 %).
   *[other] Of the { NUMBER($count) } not reviewed individually, { $estimate } are estimated to be wrong and { $most } at most ({ $share }, one-sided 95 %).
  }
lots-held = { $count ->
    [one] 1 height waits for the sample of its lot.
   *[other] { NUMBER($count) } heights wait for the sample of their lot.
  }
lots-draw-title = Draw lots from the queue
lots-draw = Draw
lots-by = Heights of a lot share
lots-by-target = target
lots-by-lighting = lighting
lots-by-operator = who measured
lots-by-day = day measured
lots-risk-producer_quality = Share of wrong heights at which a lot should pass
lots-risk-producer_risk = Risk that it does not
lots-risk-consumer_quality = Share of wrong heights at which a lot should not pass
lots-risk-consumer_risk = Risk that it does
lots-nonconforming = A height is wrong (nonconforming) if its reviewer rejects it, or fixes it by more than its U95. The sample is drawn by a seed from the audit chain before anyone reviews it. The acceptance criterion is that of ISO 2859; its tables are not used: the plan is computed for the size of each lot.
lots-nothing-waits = No heights are waiting for review outside of lots.
lots-planned = Possible lots
lots-lot = Lot
lots-size = Heights
lots-sample = Sample
lots-number = Allowed wrong
lots-what = Saves
lots-saves = { $count ->
    [one] 1 verdict
   *[other] { NUMBER($count) } verdicts
  }
lots-saves-nothing = nothing: the sample is the whole lot; review it individually
lots-everything = all heights in the queue
lots-named = Lot { $number }: { $common }
lots-of = { NUMBER($part) } of { NUMBER($all) }
lots-judged = Reviewed
lots-bad = Wrong
lots-state = State
lots-state-open = open
lots-state-accepted = accepted
lots-state-full_inspection = full inspection
lots-state-dissolved = dissolved
lots-state-taken_back = undone
lots-left = Left the lot: { $reasons }.
lots-left-measured_again = { NUMBER($count) } measured again
lots-left-withdrawn = { NUMBER($count) } withdrawn
lots-left-vehicle_deleted = { NUMBER($count) } whose vehicle was deleted
lots-left-verdict_of_its_own = { NUMBER($count) } with a verdict of their own
lots-plan = { $size } heights, sample of { $sample }, accepted with at most { $most } wrong.
lots-says-waits = { $count ->
    [one] 1 height of the sample still waits for a verdict.
   *[other] { NUMBER($count) } heights of the sample still wait for a verdict.
  }
lots-says-accept = { $count ->
    [one] Sample reviewed: 1 wrong, { $most } allowed. The lot can be accepted.
   *[other] Sample reviewed: { NUMBER($count) } wrong, { $most } allowed. The lot can be accepted.
  }
lots-says-refused = { $count ->
    [one] Sample reviewed: 1 wrong, { $most } allowed. The rest goes to full inspection.
   *[other] Sample reviewed: { NUMBER($count) } wrong, { $most } allowed. The rest goes to full inspection.
  }
lots-says-accepted = { $count ->
    [one] Accepted: { $bad } of the sample wrong, 1 height accepted with it. Of that, { $estimate } is estimated to be wrong and { $most } at most ({ $share }, one-sided 95 %).
   *[other] Accepted: { $bad } of the sample wrong, { NUMBER($count) } heights accepted with it. Of these, { $estimate } are estimated to be wrong and { $most } at most ({ $share }, one-sided 95 %).
  }
lots-says-inspected = { $count ->
    [one] Not accepted by its sample: 1 height went to the queue.
   *[other] Not accepted by its sample: { NUMBER($count) } heights went to the queue.
  }
lots-says-taken-back = { $count ->
    [one] Acceptance undone: 1 height waits again.
   *[other] Acceptance undone: { NUMBER($count) } heights wait again.
  }
lots-says-dissolved = Dissolved before the review began.
lots-judge = Review the sample
lots-accept = Accept the lot
lots-inspect = Full inspection
lots-inspect-text = { $count ->
    [one] 1 remaining height goes to the queue and cannot enter another lot.
   *[other] { NUMBER($count) } remaining heights go to the queue individually and cannot enter another lot.
  }
lots-dissolve = Dissolve
lots-take-back = Undo
lots-own = { $count ->
    [one] 1 height of the sample is your own; another person reviews it.
   *[other] { NUMBER($count) } heights of the sample are your own; another person reviews them.
  }
lots-drawn = Drawn { $when } by { $person }; seed { $seed }…
lots-nobody = Sightline
lots-curve = Probability of acceptance
lots-curve-says = The probability that the plan accepts a lot, falling with the share of wrong heights in it: with { $good } wrong it is not accepted in { $refused } of cases, with { $bad } it is accepted in { $passed }.
lots-curve-note = Exact for a lot of this size (hypergeometric). With { $good } wrong, { $refused } of such lots are not accepted; with { $bad }, { $passed } are.
lots-curve-x = wrong heights in the lot (%)
lots-curve-y = accepted (%)
lots-producer = should pass
lots-consumer = should not pass
lots-sample-of = sample of lot { $number }
lots-badge = lot { $number }
lots-sample-done = The sample of this lot is reviewed. Decide on the lot next.
lots-sample-done-title = The sample is reviewed
lots-decide = Decide on the lot
lots-show-all = Show all
lots-by-lot = Accepted by the sample of its lot; not reviewed individually.
lots-fraction-between = Enter a fraction nonconforming from 0 to below 1, for example 0.01 for 1 in 100.
lots-risk-between = Enter a risk from 0.001 to 0.5, for example 0.05 for 1 in 20.
lots-fractions-in-order = The fraction of a lot that should pass must be smaller than that of one that should not; change one of them.
lots-nothing-to-draw = No lot would save work: too few heights are waiting for these risks, or they are in lots already. Use fewer divisions, or review them individually.
lots-sample-not-judged = { $count ->
    [one] 1 height of the sample still waits for its verdict; review it first.
   *[other] { NUMBER($count) } heights of the sample still wait for their verdict; review them first.
  }
lots-too-many = { $count ->
    [one] 1 height of the sample is nonconforming; this lot is accepted with { $most } at most, so the rest goes to full inspection.
   *[other] { NUMBER($count) } heights of the sample are nonconforming; this lot is accepted with { $most } at most, so the rest goes to full inspection.
  }
lots-own-heights = You cannot accept your own heights, and the rest of this lot contains some. Ask another reviewer.
lots-judged-already = Part of this sample is already reviewed, so the lot cannot be dissolved; accept it or inspect it fully.
lots-not-accepted = Only an accepted lot can be undone; check the state of this one.
lots-decided-already = Lot { $number } was decided meanwhile; check it first.
lots-event-another-row = audit.csv: event { $number } contains another lot than it hashed; get the complete package again.
lots-verdict-without-lot = reviews.csv: a verdict by lot { $lot }, of which there is none; get the complete package again.
lots-seed-differs = lots.csv: the seed of lot { $id } does not follow from the audit chain; the draw was chosen.
lots-order-differs = audit.csv: lot { $id } was not drawn in the order of its seed; the draw was changed.
lots-plan-risk = lots.csv: the plan of lot { $id } does not keep the risks that it names; it was changed.
lots-decided-otherwise = audit.csv: the decisions on lot { $id } do not follow from each other; it was changed.
lots-sample-differs = audit.csv: the sample of lot { $id } is not the first of its draw; it was changed.
lots-counts-differ = audit.csv: the counts of lot { $id } are not those of its sample’s verdicts; one is wrong.
lots-beyond-plan = audit.csv: lot { $id } was accepted with more nonconforming heights than its plan allows, or unjudged.
lots-rest-differs = reviews.csv: the verdicts by lot { $id } are not those of its rest; some were added or removed.
lots-verdict-too-early = audit.csv: a verdict by lot { $id } came before its decision; one is wrong.
reviews-verdict-given-meanwhile = { $name } gave the verdict “{ $verdict ->
    [accepted] { state-accepted }
    [fixed] { state-fixed }
    [rejected] { state-rejected }
    [reopened] { state-reopened }
   *[to_review] { state-to_review }
}” meanwhile; check it first.

## Sight distance: the page

sight-lead = Effect of measured heights on road design: crest curves that provide a sight distance, with a standard’s heights and with the survey’s.
sight-loading = the crests
sight-form = Input values
sight-form-standard = Standard
sight-form-survey = Survey, at the standard’s percentiles
sight-form-road = Road
sight-form-fleet = Another fleet: share of each class
sight-eye = Eye of the standard
sight-object = Object of the standard
sight-standard-option = { $standard }, { $what }: { $height }
sight-standard-any = Any height
sight-standard-height = Height
sight-eye-percent = Eyes, percentile
sight-object-target = Object
sight-object-standard = The standard’s height
sight-object-percent = Objects, percentile
sight-kind = Sight distance
sight-kind-stopping = Stopping
sight-kind-decision_a = Decision, stop on a rural road
sight-kind-decision_b = Decision, stop on an urban road
sight-kind-decision_c = Decision, change on a rural road
sight-kind-decision_d = Decision, change on a suburban road
sight-kind-decision_e = Decision, change on an urban road
sight-kind-passing = Passing
sight-kind-intersection_left = Intersection, left turn from a stop
sight-kind-intersection_right = Intersection, right turn or crossing
sight-speed = Design speed
sight-difference = Grade difference
sight-headlight = Headlight (sag)
sight-radius = Radius (curve)
sight-number-problem = This number is out of range; correct it.
sight-fleet-begin = Try another fleet
sight-fleet-hint = Shares of the measured classes; change them as needed.
sight-fleet-end = Measured fleet
sight-fleet-measured = { NUMBER($eyes) } eyes, { NUMBER($objects) } objects measured
sight-case = Heights of
sight-case-standard = the standard
sight-case-survey = the survey
sight-case-mix = the other fleet
sight-sentence = Result
sight-missing = No heights of the class that the rule names match the filter for: { $targets }. Measure and accept some, choose that class, or show all states.
sight-too-few = Too few heights for the percentile: { $targets }.
sight-too-few-of = { $target } ({ $reason })
sight-read = { $whose ->
    [class] of the class that each rule names
    [chosen] of the chosen classes within the class that each rule names
    [eyes] the eyes of the class that their rule names, the objects of all vehicles counted, because their classes are not known
    [objects] the objects of the class that their rule names, the eyes of all vehicles counted, because their classes are not known
   *[all] of all vehicles counted
  }
sight-verdict-alike = { $case ->
    [mix] With the other fleet’s heights
    [study] With the study’s heights
   *[survey] With the survey’s heights
} (eye { $eye }, object { $object }) the crest constant is { $constant } instead of { $standard }, and K for { $distance } is { $k } instead of { $k_standard }. The change of { $change } is within the 95 % interval: the survey gives no reason to build crests differently.
sight-verdict-shorter = { $case ->
    [mix] With the other fleet’s heights
    [study] With the study’s heights
   *[survey] With the survey’s heights
} (eye { $eye }, object { $object }) the crest constant is { $constant } instead of { $standard }, and K for { $distance } is { $k } instead of { $k_standard }. K could be { $change } smaller, so crests shorter; on a crest built to the standard the visible distance is { $seen }.
sight-verdict-longer = { $case ->
    [mix] With the other fleet’s heights
    [study] With the study’s heights
   *[survey] With the survey’s heights
} (eye { $eye }, object { $object }) the crest constant is { $constant } instead of { $standard }, and K for { $distance } is { $k } instead of { $k_standard }. K would have to be { $change } larger, so crests longer; on a crest built to the standard the visible distance is only { $seen }.
sight-verdict-unknown = { $case ->
    [mix] With the other fleet’s heights
    [study] With the study’s heights
   *[survey] With the survey’s heights
} (eye { $eye }, object { $object }) the crest constant is { $constant } instead of { $standard }, so K changes by { $change }. There is no interval ({ $reason }), so its significance is unknown.
sight-cases-title = Crests
sight-cases-distance = { $speed }: { $formula } = { $distance }, rounded up to { $design }
sight-cases-note = { NUMBER($eyes) } eyes and { NUMBER($objects) } objects, { $whose }. Heights are true heights. Below each value: its total 95 % interval, for sampling, errors that heights share (camera pose, mean inset) and random error; errors of eye and object that come from the same camera pose are counted together; the standard’s heights and the fleet’s shares are taken as exact. Lengths are for the grade difference entered; the last column is the visible distance on a crest built to the standard.
sight-interval = { $low } to { $high }
sight-no-interval = no interval
sight-column-eye = Eye ({ $unit })
sight-column-object = Object ({ $unit })
sight-column-constant = Constant ({ $unit })
sight-column-k = K ({ $unit } per %)
sight-column-length = Minimum length ({ $unit })
sight-column-seen = Visible on the standard’s crest ({ $unit })
sight-figure-title = K of a crest against design speed
sight-figure-says = K of a crest against design speed, by the standard’s heights and by the survey’s
sight-figure-note = K = S² / C at the sight distance of each design speed, rounded up as in design tables (dots). { $bands ->
    [0] There is no interval, so no band is drawn.
   *[other] Band: 95 % interval; where none is seen, it is narrower than the line.
}
sight-figure-x = Design speed ({ $unit })
sight-figure-y = K ({ $unit } per %)
sight-besides-title = Sag and curve, independent of eye heights
sight-sag = Sag, by headlights
sight-sag-words = K { $k } { $unit } per %; minimum length { $length } { $case ->
    [within] (the sight distance lies within the curve)
    [beyond] (the sight distance extends beyond the curve)
   *[none] (these grades are lit without a curve)
}
sight-curve = Clearance beside the curve
sight-curve-words = { $offset } from the line of travel to the obstruction, at the middle of the curve
sight-curve-none = The curve is too sharp for this distance: it would extend over more than half a circle.
sight-besides-note = The headlight beam rises by 1 degree. Heights of obstructions beside a curve are not considered.

## Sight distance: what cannot be computed
sightdistance-heights = Eye heights must be above 0 and object heights 0 or more, all below 10 m; give them in metres.
sightdistance-uncertainty = A standard uncertainty must be 0 to 10 m, and 0 for an object on the road; correct it.
sightdistance-distance = A sight distance must be above 0 and below 100 km, and a length 0 or more; give metres.
sightdistance-difference = The grade difference must be above 0 and at most 100 percent; correct it.
sightdistance-speed = { $speed_kmh } km/h is not a design speed; give more than 0 and at most 300 km/h.
sightdistance-gradient = A vehicle cannot brake on a gradient of { $gradient_percent } %; give at most 25 %, and downhill less than the deceleration allows.
sightdistance-reaction-deceleration = The reaction time must be 0 or more and the deceleration more than 0; correct them.
sightdistance-passing-speed = There is no passing sight distance at { $speed_kmh } km/h; the table runs from 30 to 130 km/h.
sightdistance-headlight = The headlight’s height and its beam’s rise must not be negative, nor both 0; correct them.
sightdistance-radius = The radius must be above 0, and the distance and the offset must fit on its curve; correct them.
sightdistance-shares = The shares of a fleet must sum to 100 %; these sum to { $total_percent } %. Correct them.
sightdistance-share = “{ $share }” is not a share of a fleet; write the class, a colon and 0 to 100 percent (suv:40).
sightdistance-class-unseen = The fleet has a share of { $category }, of which the survey measured none; set that share to 0 or measure some.

## Catalogue: the page

catalogue-lead = Manufacturers’ sizes of vehicle models, each with its source, for comparison with measured heights and lengths.
catalogue-loading = the catalogue
catalogue-search = Search by make, model and year
catalogue-which = Which models
catalogue-offered = in use
catalogue-retired = retired
catalogue-none = No models
catalogue-none-found = No model matches. Search with fewer letters.
catalogue-none-yet = Import a CSV of models, or add one by hand.
catalogue-model = Model
catalogue-years = Years
catalogue-category = Class
catalogue-category-unknown = not known
catalogue-size-head = { $size } ({ $unit })
catalogue-height = Roof
catalogue-length = Length
catalogue-width = Width
catalogue-wheelbase = Wheelbase
catalogue-taillight = Taillight, lower edge
catalogue-headlight = Headlight, lower edge
catalogue-u = u = { $u }
catalogue-u-of = { $size }, u
catalogue-source-of = { $size }, source
catalogue-source = Source of the sizes
catalogue-shown = { NUMBER($first) } to { NUMBER($last) } of { NUMBER($total) }
catalogue-before = Previous
catalogue-after = Next
catalogue-correct = Correct
catalogue-correct-model = Correct { $model }
catalogue-correct-title = Correct a model
catalogue-correct-save = Save the correction
catalogue-retire = Retire
catalogue-restore = Use again
catalogue-retire-done = { $retired ->
    [yes] { $model } is retired from the catalogue.
   *[no] { $model } is used again.
}
catalogue-add = Add a model
catalogue-add-title = Add a model
catalogue-add-save = Add the model
catalogue-make = Make
catalogue-model-name = Model
catalogue-year-from = First model year
catalogue-year-to = Last model year
catalogue-needed = Required.
catalogue-year-problem = Enter four digits, for example 2019.
catalogue-number-problem = Enter a number.
catalogue-export = Export
catalogue-import = Import a CSV
catalogue-import-title = Import models from a CSV
catalogue-import-choose = Choose a CSV of models
catalogue-import-drop = Drop a CSV here
catalogue-import-hint = A header line with make and model; sizes with their unit in the header (height_m, Length (mm)).
catalogue-import-looking = the file
catalogue-import-unit = Unit of the sizes
catalogue-import-unit-header = as stated in the header, otherwise metres
catalogue-import-conflicts = Where the catalogue differs
catalogue-import-keep = keep the catalogue’s value
catalogue-import-replace = use the file’s value
catalogue-import-columns = Columns of the file
catalogue-import-in = in { $unit }
catalogue-import-left-out = skipped
catalogue-import-some-left-out = { $count ->
    [one] Not imported: the column { $columns }. Choose its meaning if it is a size, a year or an uncertainty.
   *[other] Not imported: the columns { $columns }. Choose their meaning if they are sizes, years or uncertainties.
}
catalogue-import-lines = Lines to check
catalogue-import-line = Line
catalogue-import-what = Action
catalogue-import-why = Reason
catalogue-import-store = { $count ->
    [0] Nothing to save
    [one] Save { NUMBER($count) } model
   *[other] Save { NUMBER($count) } models
}
catalogue-import-done = { NUMBER($added) } models added, { NUMBER($updated) } updated.
catalogue-change-new = new
catalogue-change-update = filled in
catalogue-change-same = unchanged
catalogue-change-conflict = conflict
catalogue-change-duplicate = duplicate in the file
catalogue-change-refused = rejected
catalogue-unit-m = metres
catalogue-unit-cm = centimetres
catalogue-unit-mm = millimetres
catalogue-unit-ft = feet
catalogue-unit-in = inches

## Catalogue: what an import says of a line, and what cannot be stored
catalogue-make-and-model = Enter both make and model.
catalogue-too-long = A make has at most { $most_make } characters and a model { $most_model }; shorten it.
catalogue-years-reversed = The last year is before the first; swap them.
catalogue-sizes-contradict = { $column } is { $value } and { $other } is { $large }, which no vehicle has; correct one of the two.
catalogue-control-characters = A make, model or source has a character that cannot be shown; type it again.
catalogue-say-the-columns = { $name } has no column { $missing }; assign one of its columns, or name it so in the first line.
catalogue-no-rows = { $name } has a header and no line of models below it; add one.
catalogue-column-twice = The columns { $first } and { $second } are both { $field }; choose which of them counts.
catalogue-size-impossible = { $column } is { $value }, which is not plausible for a vehicle; give it in metres, from { $low } to { $high }.
catalogue-size-unit = { $column } is { $value }, which is not plausible in metres; in { $unit } it would be { $metres } m. Give it in metres, or state the unit.
catalogue-u-impossible = { $column } is { $value } m, which is not a plausible standard uncertainty of this size; state its unit, or give metres, from 0 to { $most }.
catalogue-unit-doubtful = { $column }: half of its values are { $middle } or more, which is not plausible in { $unit }; they look like { $other }. Nothing was saved. State the unit as { $sign }, or convert the file.
catalogue-there-already = { $make } { $model } ({ $year }) is already in the catalogue; correct that row instead.
catalogue-changed-meanwhile = { $make } { $model } was changed meanwhile; check it and repeat your change.
catalogue-no-such-field = The catalogue has no field “{ $field }”; use one of { $known }.
catalogue-column-choice = “{ $column }” does not assign a column; write the field, an equals sign and the header (height_m=Roof).
catalogue-duplicate = The same model as line { $line }; skipped.
catalogue-duplicate-differs = The same model as line { $line } with other values ({ $differences }); skipped. Keep one of the two.
catalogue-conflict-keep = { $differences }; the catalogue’s value is kept.
catalogue-conflict-replace = { $differences }; the value of this line replaces it.
catalogue-differs = { $here } here, { $there } there
catalogue-fills-in = Fills in { $columns }.

studies-fleet-header = { $path } needs a column category (or lighting, stratum, site), or the two columns variable and class, and a column share or registrations; add them.
studies-fleet-variable = { $path }, row { $row }: a fleet cannot be divided by { $cell }; use one of { $known }.
studies-fleet-class-twice = { $path }, row { $row }: { $name } appears twice; keep one row.
studies-fleet-empty = { $path } has no rows; give one row per class.
studies-shares-sum = { $path }: the shares of { $variable } sum to { $total }, not to 1; correct them, or give registrations instead.
studies-registrations-sum = { $path }: { $first } sums to { $first_sum } vehicles and { $other } to { $other_sum }; both must describe the same fleet.
studies-sites-header = { $path } needs the columns site and stratum; add them.
studies-sites-there-differ = { $path }, row { $row }: stratum { $stratum } has another sites_there in an earlier row; write the same number, or none, in each of its rows.
studies-traffic-of-some = { $path }: traffic is given for some sites only, or is 0; give it for all sites or for none.
studies-not-a-count = { $path }, row { $row }: { $name } is { $cell }, not a whole number from 1; correct it or leave it empty.
studies-not-an-amount = { $path }, row { $row }: { $name } is { $cell }, not a number from 0; correct it.
studies-no-package-there = { $place } is not a package and contains none; name packages (folders or ZIPs), or a folder of them.
studies-package-unverified = { $place } does not verify, so it cannot be used in a study: { $problem }
studies-package-lacks-column = { $place } (version { $version }) lacks the column { $column } of { $table }, which a study needs; export its survey again.
studies-package-word-unknown = { $place } (version { $version }) has “{ $word }” in the column { $column } of { $table }, which this version does not know; use that version or a later one.
studies-package-without-parquet = { $place } was made by an earlier version, without Parquet; export its survey again.
studies-survey-without-poses = { $place } has no camera pose and therefore no heights; leave it out, or compute the poses of its recordings (and export a package again).
studies-same-survey-twice = { $first } and { $second } are packages of the same survey; keep the later one.
studies-no-height-counts = None of the surveys has an accepted height that counts; review measurements (and export a package again).
studies-class-unknown = The fleet has { $variable } { $name }, which Sightline does not know; use { $known }.
studies-class-never-seen = The fleet has { $variable } { $name }, which no survey contains; leave it out and let the other shares sum to 1, or measure some.
studies-fleet-lacks-class = The surveys contain { NUMBER($count) } vehicles of { $variable } { $name }, which the fleet does not have; add a row for it (0 to exclude it).
studies-site-missing = The table of sites has no row for { $site }; add it.
studies-too-many-sites = Stratum { $stratum } has { NUMBER($count) } sites here, but sites_there is { $there }; correct it.
studies-needs-a-name = A study needs a name; enter one.
studies-needs-each-survey = You do not see every survey of this study now; ask a manager of those surveys to add you.
studies-open-needs-managers = You do not manage { $name }; only someone who manages each survey of a study can show it to everyone. Ask a manager of { $name }.
studies-has-no-survey = The study has no survey; add at least one.
studies-goal-of-study = { $goal } m is not a U95 between 0 and 1 m; 0.010 m is 10 mm.
studies-survey-stands-twice = { $name } is in the study twice; keep it once.
studies-no-year = { $year } is not a possible year for { $name }; correct it, or leave it empty.
studies-two-strata = Site { $site } is in stratum { $first } and in stratum { $second }; give it one, in all its surveys and in the table of sites.
studies-site-without-stratum = Site { $site } has no stratum, though others have one; give every site one, or none.
studies-changed-meanwhile = { $name } changed this study on { $when }. Reload it and repeat your change.
studies-goal-no-length = --goal { $goal } is not a U95 in metres between 0 and 1; 0.010 is 10 mm.
studies-compared-with-itself = { $name } cannot be compared with itself; choose another study.
studies-compared-without-figures = { $name } has not been computed; compute it first.
studies-fleet-two-amounts = { $path } has a column share and a column registrations; keep the one that counts.
studies-registrations-of-nobody = { $path }: { $variable } sums to 0 vehicles; give the numbers of vehicles.
studies-output-in-package = { $place } is a package of a survey, or lies in one; name a folder of its own for the study.
traffic-duration-twice = { $path } states its own duration; leave --duration out.
traffic-no-duration-inside = { $path } does not state its duration; write it again with sightline linescan --json.
traffic-own-lanes = The vehicles of { $name } have lanes of their own ({ $lanes }); leave out --lane.
traffic-no-duration = { $path } contains lines of sightline stream, which do not state the duration; give --duration in seconds.
traffic-no-recording = { $path } is not output of sightline linescan --json or sightline stream; give one of those.
traffic-file-too-large = { $path } is larger than { $most_gb } GB; add the recording in parts.
traffic-cannot-read = { $path } cannot be read ({ $strerror }); give the output of sightline linescan --json or sightline stream.
traffic-vehicle-without = Vehicle { $vehicle } of { $path } has no readable { $column }; write it again with sightline linescan --json.
traffic-number-twice = { $path } has vehicle { $vehicle } twice; give one recording per file.
traffic-outside-recording = Vehicle { $vehicle } of { $path } passed from { $front_s } s to { $rear_s } s, outside the recording’s { $duration_s } s; correct --duration, or write the file again.
import-videos-or-folder = Name videos, or a folder with --watch, and not both; see sightline import --help.
import-no-token = A token is needed: make one in Account with read and upload, and set SIGHTLINE_TOKEN to it.
import-no-address = “{ $url }” is not an address of Sightline; write it as http://name:8000.
import-no-answer = { $url } does not answer; check the address, and that the server is running.
import-no-sightline = { $url } answered with status { NUMBER($status, useGrouping: 0) }, but not as Sightline does; check the address.
import-server-said = The server answered: { $sentence }.
import-no-such-survey = There is no survey “{ $survey }” that you can see; yours are: { $names }.
import-survey-name-twice = Several surveys are called “{ $survey }”; give the number of one: { $numbers }.
import-no-such-file = { $name } is not a file; check the name.
import-no-such-folder = { $name } is not a folder; name an existing one.
import-not-a-video = { $name } does not have the ending of a video; videos end with { $suffixes }.
import-empty-file = { $name } is empty; give the file that the camera wrote.
import-changed-meanwhile = { $name } was changed while it was uploaded; delete its recording, and import the file again when it is finished.
import-cannot-be-read = { $name } was uploaded but cannot be read: { $reason }.
import-passes-not-found = { $name } was imported, but its passes were not found: { $reason }.
traffic-recording-there = { $name } is already in the archive (site { $site }, { $day }); remove it first with: sightline traffic remove
traffic-other-zone = Site { $site } uses the time zone { $there }, not { $zone }; give that zone, or another site.
traffic-overlap = { $name } and { $other }, which is in the archive, both observed this lane of { $site } from { $start } to { $end }; correct --start, or name the lane with --lane.
traffic-no-name = "{ $name }" cannot name a { $what } here; use up to { $most } letters, digits, spaces and - _ . with no dot in front.
traffic-no-such-recording = { $path } has no recording { $name }; give its file’s name or the beginning of its SHA-256.
traffic-several-recordings = { $path } has several recordings that match { $name }; give the beginning of the SHA-256 of one.
traffic-no-archive = { $path } is not a traffic archive; create one with: sightline traffic add
traffic-being-changed = { $path } is being changed by another process; try again when it is done.
traffic-cannot-write = { $path } cannot be written ({ $strerror }); choose another folder, or free some space.
traffic-no-u-start = --u-start { $u_start_s } is not a standard uncertainty in seconds; give 0 or more.
traffic-duration-not-positive = --duration { $duration_s } is not a time in seconds above 0; correct it.
traffic-no-minutes = --minutes { $minutes } does not divide a day; use 1, 5, 15, 30, 60 or another that does.
traffic-no-percents = --percentile { $text } must be different numbers above 0 and below 100, as in 15,50,85.
traffic-no-limits = --lengths { $text } must be increasing lengths in metres between 0 and 100, as in 6,12.
traffic-no-numbers = { $option } { $text } contains something that is not a number; separate numbers by commas.
traffic-no-day = { $option } { $text } is not a day; write it as 2026-05-04.
traffic-days-turned = --to { $last } is before --from { $first }; swap them.
traffic-no-such-site = The archive has no site { $site }; it has { $there }.
commands-errors-several-targets = The heights are of { $targets }; use --by target to compare each with its references.
commands-errors-unknown-word = Line { $line }: { $column } is “{ $word }”; use one of { $known }.
commands-compare-two-values = --compare { $text } needs --by and two different values of its column, as in --by year --compare 2020,2026.
commands-compare-value-unknown = No row with a height has { $name } in { $by }; compare two of { $known }.

## The page that a package carries (index.html): read without a server; it shares no code with what measured

opened-reading = Reading the package…
opened-unreadable = This page cannot read the package that it carries. Use a browser of 2023 or later, or run sightline verify.
opened-broken = This page stopped because of an error, so it shows no result. Run sightline verify to check the file.
opened-made-with = Made with Sightline { $version }.
opened-only = This package is limited. Statistics, figures and report cover only: { $only }. The survey’s other vehicles are in the tables and excluded from the results.
opened-report = Report (PDF)
opened-measurements = Measurements
opened-figures = Figures
opened-tables = Tables
opened-tables-lead = Numbers are rounded here; the files contain all digits. datapackage.json describes each column.
opened-table = { $table ->
    [survey] the survey, in one row
    [vehicles] passes and vehicles
    [recordings] video files
    [poses] camera poses
    [insets] default insets of the survey
    [selection] limits of this package
    [people] people named in the other tables
    [exclusions] measurements excluded from the results, with the reason
    [response] outcome of the passes
    [error_table] errors of accepted roofs (measured minus manufacturer’s height)
    [agreement] limits of agreement, and regression of the error on the height
    [corrections] effect of each correction on the heights
    [percentiles] percentiles of the heights, with 95 % intervals
    [total_uncertainty] figures of the true heights, with total intervals
    [same_rule] verdict on each design standard
    [shares] share of heights below the value of each standard
   *[lateral_positions] lateral positions of the vehicles
}
opened-checks = Checks
opened-sizes = Sizes
opened-checking = Checking the package…
opened-is-fine = The checks of this page found no contradiction.
opened-is-wrong = This package was changed after it was made.
opened-failed = The package could not be read completely: { $words }.
opened-heights-agree = { $count ->
    [one] The height was computed again from its clicks and agrees.
   *[other] { NUMBER($count) } heights were computed again from their clicks and agree.
  } The largest difference is { NUMBER($off_um, maximumFractionDigits: 2) } µm; tables are written to the micrometre.
opened-heights-refused = { $count ->
    [one] One was not computed: see its row.
   *[other] { NUMBER($count) } were not computed: see their rows.
  }
opened-heights-differ = { $count ->
    [one] One measurement differs from what its clicks give: { $named }.
   *[other] { NUMBER($count) } measurements differ from what their clicks give: { $named }.
  }
opened-chain-whole = { $count ->
    [one] The audit chain of 1 event is intact.
   *[other] The audit chain of { NUMBER($count) } events is intact: each event matches its hash and follows the one before.
  }
opened-chain-broken = The audit chain is broken at event { $number }.
opened-chain-absent = The audit chain was not checked: audit.js is not beside this page, or the chain is too large for a page. Drop the package’s ZIP or folder here, or use sightline verify.
opened-seal-none = The audit chain does not end with the seal of a package.
opened-seal-chain = The audit chain before the seal is not the one named by the seal.
opened-seal-holds = The { NUMBER($count) } files that this page carries match the seal.
opened-seal-wrong = Files that do not match the seal: { $named }.
opened-rows-agree = Every measurement matches its audit event.
opened-rows-differ = { $count ->
    [one] One measurement differs from its audit event: { $named }.
   *[other] { NUMBER($count) } measurements differ from their audit events: { $named }.
  }
opened-poses-agree = Every camera pose matches its audit event.
opened-poses-differ = Camera poses that differ from their audit events: { $named }.
opened-signature-holds = Signed on { $at } with key { $key }…: compare it with the key shown by the installation.
opened-signature-wrong = The signature is not valid for the end of this chain.
opened-signature-unknown = The signature was not checked because this browser does not support Ed25519. Use sightline verify.
opened-folder-choose = Check the files too: drop the package’s ZIP or folder anywhere on this page, or choose it here. Nothing leaves this computer.
opened-folder-folder = The folder that contains this page
opened-folder-zip = Or the package’s ZIP
opened-folder-unreadable = The files were not checked: the selection is not a complete package. Get the ZIP again, or choose the folder.
opened-folder-checking = Checking the files…
opened-folder-fine = All { NUMBER($count) } files of the package ({ NUMBER($mb, maximumSignificantDigits: 2) } MB) match the seal.
opened-folder-changed = Changed after the export: { $named }.
opened-folder-missing = Missing from the package: { $named }.
opened-folder-strange = Not part of the package: { $named }.
opened-what-title = Which checks are made where
opened-what-here = Here, from the copies of the tables that this page carries: every current height from clicks, lens and camera pose, with this page’s own arithmetic; U95 as 1.96 u and u as the root sum of squares of its budget; the audit chain with its seal and signature; every measurement and camera pose against its audit event.
opened-what-folder = Only after you choose the folder or drop the ZIP: whether the files of the package (images, figures, report, tables) match the seal. A browser does not let a page read other files without asking.
opened-what-verify = Only with sightline verify: earlier revisions and repeats, the components of the budgets, verdicts against reviews, vehicles, line scans, recomputed statistics, figures and report, Parquet against CSV.
opened-what-page = A page can be forged as a whole and would then state whatever its forger wants. If it matters, run sightline verify with the key shown by the installation.
opened-measurements-none = This package has no measurements.
opened-figures-none = No figures: too few accepted measurements.
opened-left-out = Too large for this page, so neither shown nor checked here: { $named }. Use sightline verify.
opened-table-empty = No rows.
opened-table-cut = The first { NUMBER($shown) } of { NUMBER($count) } rows; the file contains all.
opened-sizes-total = { $files ->
    [one] { NUMBER($files) } file
   *[other] { NUMBER($files) } files
}, { NUMBER($mb, maximumSignificantDigits: 3) } MB, not counting this page, the description, the audit chain and the checksums.
opened-size-top = { $files ->
    [one] { NUMBER($files) } file
   *[other] { NUMBER($files) } files
} at the top, { NUMBER($mb, maximumSignificantDigits: 2) } MB
opened-size = { $folder } { $files ->
    [one] { NUMBER($files) } file
   *[other] { NUMBER($files) } files
}, { NUMBER($mb, maximumSignificantDigits: 2) } MB
opened-filter = Show
opened-filter-all = all
opened-filter-differs = those that differ
opened-filter-stale = those out of date
opened-stale-count = { $count ->
    [one] { NUMBER($count) } height is out of date: it follows from a camera pose, an inset or a driver’s side that was changed after it was computed. It is included unchanged.
   *[other] { NUMBER($count) } heights are out of date: they follow from a camera pose, an inset or a driver’s side that was changed after they were computed. They are included unchanged.
}
opened-stale-mark = out of date
opened-stale = { $cause ->
    [pose] Out of date: the camera pose was changed after it was computed.
    [inset] Out of date: the inset was changed after it was computed.
   *[side] Out of date: the driver’s side was changed after it was computed.
}
opened-before = Previous
opened-after = Next
opened-range = { NUMBER($from) } to { NUMBER($to) } of { NUMBER($count) }
opened-target-roof = Roof
opened-target-driver_eye = Driver’s eye
opened-target-taillight = Taillight
opened-target-headlight = Headlight
opened-target-other = Other
opened-verdict-accepted = accepted
opened-verdict-fixed = fixed
opened-verdict-rejected = rejected
opened-verdict-unreviewed = not reviewed
opened-withdrawn = withdrawn
opened-outside = { $verdict }; outside the limits
opened-column-id = No.
opened-column-target = Target
opened-column-package = Height in the package
opened-column-here = Computed here
opened-column-review = Review
opened-height = { $height_m } ± { $U95_m } m
opened-height-here = { $height_m } m
opened-height-none = no height
opened-refused-pose = not computed: its camera pose is not in the package
opened-refused-form = not computed: the table lacks some of its frames
opened-one = Measurement { $id }: { $target }
opened-crops-none = There is no image of it in this package.
opened-crops-outside = Outside the limits of this package ({ $only }), so it has no image here and is excluded from the results.
opened-crop = Frame { $frame } with both points
opened-differs = Differs from what the clicks give: { $named }.
opened-pair-package = Height in the package, m
opened-pair-here = Computed on this page
opened-pair-off = Difference
opened-nanometres = { $off_nm } nm
opened-pair-contact = Tyre contact, px
opened-pair-target = Target, px
opened-pair-inset = Inset, m
opened-pair-frame = Recording and frame
opened-pair-pose = Camera pose
opened-pair-u = u from { $source }, m

## What the columns mean that a package's page explains, as the tables say it

column-measurements-id = measurement (a series of revisions)
column-measurements-revision = number of the current revision, from 1
column-measurements-vehicle-id = vehicle that was measured
column-measurements-recording-id = recording in which the points were clicked
column-measurements-target = what was measured
column-measurements-frame = frame number: the n-th decoded frame, from 0
column-measurements-pts = presentation time stamp of that frame, in the stream's own time base
column-measurements-time-s = time of that frame from the start of the stream
column-measurements-frame-crc32 = CRC-32 of the decoded luma of that frame: proof of what was clicked on
column-measurements-contact-x-px = where the tyre meets the road, x to the right; (0, 0) is the centre of the top-left pixel
column-measurements-contact-y-px = where the tyre meets the road, y down; (0, 0) is the centre of the top-left pixel
column-measurements-target-x-px = the target point, x to the right; (0, 0) is the centre of the top-left pixel
column-measurements-target-y-px = the target point, y down; (0, 0) is the centre of the top-left pixel
column-measurements-sigma-px = standard uncertainty of each coordinate of each click
column-measurements-made = how the points on `frame` were set: clicked: by hand (the contact may be a proposed one where no target was proposed); snapped: the contact moved from a click to the tyre found there; confirmed: as proposed; moved: from proposed or found points (contact or target), at least one of which a person placed
column-measurements-snapped-from-x-px = where a person clicked before the contact went to the tyre found there, x to the right; (0, 0) is the centre of the top-left pixel
column-measurements-snapped-from-y-px = where a person clicked before the contact went to the tyre found there, y down; (0, 0) is the centre of the top-left pixel
column-measurements-proposal = whether contact and target were proposed on `frame` when it was measured: shown, or withheld: the vehicle was drawn to be measured free; empty where one of them was not proposed
column-measurements-proposed-contact-x-px = where the contact was proposed, x to the right; not used for any height; (0, 0) is the centre of the top-left pixel
column-measurements-proposed-contact-y-px = where the contact was proposed, y down; not used for any height; (0, 0) is the centre of the top-left pixel
column-measurements-proposed-target-x-px = where the target was proposed, x to the right; not used for any height; (0, 0) is the centre of the top-left pixel
column-measurements-proposed-target-y-px = where the target was proposed, y down; not used for any height; (0, 0) is the centre of the top-left pixel
column-measurements-pose-id = camera pose used
column-measurements-calibration-id = calibration behind that pose
column-measurements-inset-m = inset: distance from the vertical plane through the contact point to the target, along road Y
column-measurements-u-inset-m = standard uncertainty of the inset (k = 1)
column-measurements-side = of an eye: side of the vehicle, seen from the camera, on which the driver sits
column-measurements-side-from = source of the side: entered for this vehicle, its direction, or the lane next to the camera
column-measurements-inset-from = whether the inset is the survey's usual one or this measurement's own
column-measurements-frames = number of frames on which the points were clicked, or followed through a whole pass
column-measurements-frame-n = number of frame { $frame } that the points were clicked on
column-measurements-contact-n-x-px = the same tyre contact on frame { $frame } of the measurement, x
column-measurements-contact-n-y-px = the same tyre contact on frame { $frame } of the measurement, y
column-measurements-target-n-x-px = the same target point on frame { $frame } of the measurement, x
column-measurements-target-n-y-px = the same target point on frame { $frame } of the measurement, y
column-measurements-followed = of a whole pass: JSON of the points followed from those on `frame` (docs/formats.md); height_m is then that of all of them
column-measurements-solved-inset-m = the inset found from several frames or a whole pass; inset_m is then not used for height_m, of a whole pass only as what is known beforehand
column-measurements-u-solved-inset-m = standard uncertainty of the inset found (k = 1)
column-measurements-height-m = height of the target above the road along its normal, corrected for the inset
column-measurements-uncorrected-height-m = the first frame's height with an inset of 0 (the paper's assumption)
column-measurements-u-height-m = standard uncertainty of height_m (k = 1)
column-measurements-u95-height-m = half-width of the 95 % interval of height_m
column-measurements-x-m = contact point along the road, from the pose's origin (X)
column-measurements-y-m = contact point across the road, away from the camera (Y)
column-measurements-u-clicks-m = component of u_height_m from the clicks, which no other height shares
column-measurements-u-by-inset-m = component of u_height_m from the assumed inset; the remaining component is that of the camera pose
column-measurements-distance-m = from the camera's centre to the contact point
column-measurements-status = whether there is a height
column-measurements-reason = why there is no height
column-measurements-reason-code = reason by code and values (JSON)
column-measurements-flags = warnings on this height, separated by semicolons
column-measurements-flags-code = flags by code and values (JSON)
column-statistics-warning-code = warning by code and values (JSON)
column-statistics-words-code = words by code and values (JSON)
column-measurements-code-version = version of the program that computed the height
column-measurements-created-by-id = who made the revision: clicked the points, withdrew the measurement or restored it; of a recomputed one, as of the revision before
column-measurements-operator-id = who clicked the points that stand, the maker of the first revision with them: the operator of all statistics
column-measurements-clicked-at = when the points that stand were clicked: the day of measuring
column-measurements-created-at = when the revision was stored
column-measurements-withdrawn = true if the measurement was withdrawn
column-measurements-computing-id = recomputation that made this revision from the clicks of the previous one
column-measurements-verdict-of-revision = the revision before it whose verdict holds for this one too: computed again, it moved by no more than its u, or its points were put back where they were
column-measurements-filmed-at = when that frame was filmed, by the clocks of the place (ISO 8601 with offset): started_at of its recording and time_s; none while nobody has confirmed that start
column-measurements-verdict = state of the review of this revision
column-measurements-review-reason = the reviewer's reason
column-measurements-reviewer-id = who reviewed
column-measurements-reviewed-at = when it was reviewed
column-measurements-verdict-by = whether a reviewer judged this measurement itself, or its lot by a sample
column-measurements-lot-id = of a verdict by lot: the lot
column-measurements-out-of-date = why the height is out of date, separated by semicolons: pose, inset or side where it follows from another recording's road pose, another usual inset or another side of the driver than holds now in this package; empty: it is not. Compute the heights again in the survey and export it anew
column-budget-measurement-id = measurement
column-budget-source = source of uncertainty
column-budget-u-m = its contribution to the standard uncertainty of the height
column-survey-id = survey, in the database that it comes from
column-survey-name = name of the survey
column-survey-site = where it was filmed; a study takes surveys of one site as one cluster
column-survey-description = description of the survey
column-survey-simulated = true: invented; no value of it describes real roads
column-survey-latitude-deg = latitude (WGS84), north positive
column-survey-longitude-deg = longitude (WGS84), east positive
column-survey-road-class = class of the road, in words
column-survey-lane = measured lane, in words
column-survey-travel-direction = travel direction, in words
column-survey-speed-limit-mps = speed limit
column-survey-street-lamps = whether the road has street lamps
column-survey-time-zone = time zone of the site (IANA), proposed for recordings
column-vehicles-id = vehicle
column-vehicles-number = its number within the survey
column-vehicles-recording-id = recording it passes in
column-vehicles-first-frame = first frame of the pass
column-vehicles-last-frame = last frame of the pass
column-vehicles-best-frame = frame proposed for measuring
column-vehicles-make = manufacturer
column-vehicles-model = model
column-vehicles-year = model year
column-vehicles-model-chosen-by = size: the model was chosen because it fits what was measured, so no height known of the vehicle is a reference; seen: it was then recognised on the vehicle; empty: neither
column-vehicles-model-sizes = of a model chosen by size: by which sizes, a space between them
column-vehicles-category = body type
column-vehicles-manufacturer-height-m = manufacturer's overall height
column-vehicles-u-manufacturer-height-m = standard uncertainty of that height (k = 1)
column-vehicles-height-source = where that height comes from
column-vehicles-known-driver-eye-m = height of its driver eye that was known before it was measured
column-vehicles-known-taillight-m = height of its taillight that was known before it was measured
column-vehicles-known-headlight-m = height of its headlight that was known before it was measured
column-vehicles-known-other-m = height of its mark that was known before it was measured
column-vehicles-check-target = a staff with marks, or a car with taped heights, present to check the measurement: own rows in errors_by_target.csv, not part of the traffic
column-vehicles-lighting = light at the time of the pass
column-vehicles-direction = travel direction in the image
column-vehicles-driver-side = side of the driver as entered, seen from the camera; none where it follows from the direction
column-vehicles-roof-not-visible = why the roof cannot be measured of this vehicle; none where it can
column-vehicles-driver-eye-not-visible = why the driver eye cannot be measured of this vehicle; none where it can
column-vehicles-taillight-not-visible = why the taillight cannot be measured of this vehicle; none where it can
column-vehicles-headlight-not-visible = why the headlight cannot be measured of this vehicle; none where it can
column-vehicles-first-s = time of first_frame since the first frame of its recording, from the frame table; none where that is missing
column-vehicles-filmed-at = when its first frame was filmed, by the clocks of the place (ISO 8601 with offset): first_s after started_at of its recording; none while nobody has confirmed that start
column-vehicles-in-sample = whether the rule of sampling.csv selects it
column-vehicles-counts = whether its heights count in the results: not a check target, and in the sample, unless sampling.csv counts others too
column-vehicles-discarded = why this is not the pass of a vehicle to be measured; none if it is
column-vehicles-notes = remarks
column-vehicles-state = how far the work on it has come, given what the survey asks for
column-recordings-id = recording
column-recordings-name = name of the file
column-recordings-sha256 = SHA-256 of the file
column-recordings-size-bytes = size of the file
column-recordings-width-px = width of a frame
column-recordings-height-px = height of a frame
column-recordings-frame-count = number of decoded frames
column-recordings-duration-s = time from the first frame to the end of the last
column-recordings-codec = codec of the video stream
column-recordings-container = container of the file
column-recordings-variable-rate = true where the time between frames varies
column-recordings-stream-number = which of the file's pictures was read, from 1; none where it has only one
column-recordings-filmed-hz = frames per second when it was filmed, where a person had to state it
column-recordings-lighting = light in the recording
column-recordings-started-at = when its first frame was filmed, as a person confirmed, by the clocks of the place (ISO 8601 with offset)
column-recordings-time-zone = time zone of these times (IANA)
column-recordings-weather = weather, in words
column-recordings-street-lighting = whether the street lamps were on
column-recordings-camera-id = camera that filmed it
column-recordings-pose-id = current camera pose
column-recordings-drift-state = whether the camera moved since that pose
column-recordings-drift-floor-px = detection limit of camera movement
column-recordings-drift-moved-px = largest motion found, where it moved
column-recordings-drift-height-m = largest error that it gives a height of 1.2 m on the nearest road in the picture, 3 m away or more; different at other distances
column-recordings-drift-distance-m = distance across from the camera at which that error is
column-recordings-drift-checked-at = when this was checked
column-recordings-drift-decision = reason for keeping the pose although the camera moved
column-recordings-drift-decided-by-id = who decided that
column-recordings-drift-decided-at = when that was decided
column-poses-id = camera pose
column-poses-recording-id = recording in which the board stood on the road
column-poses-calibration-id = calibration it was solved with
column-poses-first-frame = first frame of the board's segment
column-poses-last-frame = last frame of the board's segment
column-poses-frames-used = frames that entered the solution
column-poses-rms-px = RMS reprojection error of the corners
column-poses-board-distance-m = from the camera's centre to the board
column-poses-board-columns = inner corners in a row of the board
column-poses-board-rows = rows of inner corners
column-poses-square-m = side of a square
column-poses-reference = row of inner corners whose height was measured
column-poses-reference-height-m = height of that row above the road
column-poses-u-lean-rad = standard uncertainty of the board's lean (k = 1)
column-poses-u-square-m = standard uncertainty of the side of a square (k = 1)
column-poses-u-bow-m = standard uncertainty of the board's middle out of plane (k = 1)
column-poses-turned-from = the pose that this one was, before it was turned to the traffic
column-poses-turned-by-rad = by how much it was turned about the road's normal
column-poses-adjusted-from = the pose that this one was, before it was adjusted by its traffic (account: its document)
column-poses-document = the pose as a file of this package (sightline-pose-1)
column-poses-created-by-id = who made it
column-poses-created-at = when it was made
column-insets-target = what is measured; of a driver's eye for the driver on the near or on the far side
column-insets-note = where the figure comes from
column-selection-by = what is chosen by
column-selection-word = the lighting, set of classes, class, day, or hour of the day by the clocks of the place
column-people-id = person
column-people-name = name
column-crops-k = which of the measurement's frames, from 1
column-crops-file = the crop in this package
column-crops-overlay = the same with its points, as SVG
column-crops-sha256 = SHA-256 of the crop
column-crops-x-px = column of the frame in which the crop begins
column-crops-y-px = row of the frame in which the crop begins
column-crops-width-px = width of the crop
column-crops-height-px = height of the crop
column-crops-contact-x-px = where the tyre meets the road, in the crop, x to the right; (0, 0) is the centre of the crop's top-left pixel
column-crops-contact-y-px = where the tyre meets the road, in the crop, y down; (0, 0) is the centre of the crop's top-left pixel
column-crops-target-x-px = the target point, in the crop, x to the right; (0, 0) is the centre of the crop's top-left pixel
column-crops-target-y-px = the target point, in the crop, y down; (0, 0) is the centre of the crop's top-left pixel
column-crops-reason = why there is no crop
column-exclusions-measurement-id = excluded measurement
column-exclusions-state = state for which it is excluded
column-exclusions-reason = the reason in words
column-response-lighting = all, daytime, low_light, or unknown
column-response-class-set = all, a set of classes (classes.csv), or none
column-response-target = what is asked for; empty: the vehicle as a whole
column-response-passes = passes found
column-response-discarded = of them discarded (vehicles.csv says why)
column-response-out-of-sample = of them out of the sample
column-response-in-sample = of them in the sample
column-response-measured = of the sample measured
column-response-not-visible = of the sample not visible
column-response-open = of the sample open
column-response-outside = measured though out of the sample
column-response-rate = response rate: measured over in_sample
column-response-low = lower end of its exact 95 % interval
column-response-high = upper end of its exact 95 % interval
column-error-table-heights = inset: heights corrected by each measurement's inset; as_in_the_paper: with an inset of 0, both heights of an error to whole centimetres
column-error-table-rounding = cm: both heights to whole centimetres as the paper does; none: not rounded
column-error-table-group = group
column-error-table-figure = name of the value
column-error-table-n = number of measurements
column-error-table-value = value
column-error-table-low = lower end of its 95 % interval
column-error-table-high = upper end of its 95 % interval
column-error-table-holds = components of its interval, separated by spaces
column-error-table-reason = why a value or its interval is missing
column-agreement-figure = which figure; _m, and intercepts: metres
column-corrections-correction = which correction of the heights (corrections.csv says what was done)
column-corrections-mean-m = mean of the corrected heights
column-corrections-sd-m = standard deviation of the corrected heights (n - 1)
column-corrections-words = description of the correction
column-corrections-warning = warning
column-percentiles-grouping = what divides the measurements; all: nothing
column-percentiles-percent = which percentile
column-percentiles-height-m = the percentile
column-total-uncertainty-percent = of a percentile: which
column-total-uncertainty-limit-m = of a share: below which height
column-total-uncertainty-value = the figure: a height or SD in metres, a share from 0 to 1
column-total-uncertainty-raw-m = of a percentile: the plain one of the measured heights
column-total-uncertainty-holds = components of the interval, separated by spaces
column-same-rule-what = what the standard's height is of
column-same-rule-standard = name of the standard
column-same-rule-standard-m = the standard's height
column-same-rule-percent = the percentile of its rule
column-same-rule-class = of which vehicles, as the standard says
column-same-rule-by-class = false: no class is known, all vehicles count
column-same-rule-height-m = the same percentile today, of true heights
column-same-rule-low-m = lower end of its total 95 % interval
column-same-rule-high-m = upper end of its total 95 % interval
column-same-rule-difference-m = today's percentile minus the standard's height
column-same-rule-lower = probability that today's percentile is below the standard's height
column-same-rule-verdict = verdict
column-same-rule-risk = probability that the verdict is wrong
column-shares-source = where the standard's value is from
column-shares-below = number of heights below it
column-shares-share = share of the heights below: below divided by n
column-lateral-positions-lane = travel direction in the image; empty: all
column-lateral-positions-class = body of the vehicles; empty: all

## The page of an evidence file: opened without a server, by somebody who has nothing else

opened-evidence-unreadable = This page cannot read its data: the file was truncated or changed.
opened-evidence-title = Vehicle { $number }, { $scan }
opened-evidence-made = Evidence file made on { $at } UTC by { $by } with Sightline { $version }.
opened-evidence-nobody = nobody signed in
opened-evidence-checking = Checking the file…
opened-evidence-is-fine = The checks of this page found no contradiction.
opened-evidence-is-wrong = This file was changed after it was made.
opened-evidence-failed = The file could not be checked completely: { $words }.
opened-evidence-text-fine = The data are in exactly the form that is signed (RFC 8785).
opened-evidence-text-wrong = The data are not in the form that is signed.
opened-evidence-pictures-fine = Both images match the SHA-256 in the data.
opened-evidence-pictures-wrong = Images that do not match the data: { $named }.
opened-evidence-events-fine = { $count ->
    [one] The audit event matches its hash.
   *[other] The { NUMBER($count) } audit events match their hashes.
  }
opened-evidence-events-wrong = Audit events that do not match their hashes: { $named }.
opened-evidence-event-fine = The motion matches its audit event.
opened-evidence-event-wrong = The motion differs from its audit event: { $named }.
opened-evidence-signature-holds = The signature is valid for key { $key }…
opened-evidence-signature-wrong = The signature is not valid for key { $key }…
opened-evidence-signature-unknown = The signature was not checked because this browser does not support Ed25519; the hashes were checked. Use sightline verify, or a newer browser.
opened-evidence-proves = A signature proves only that the holder of this key signed these data: not who holds the key, nor that the data are true, nor when they were made. Compare the key with the key shown by the installation.
opened-evidence-what-here = Here: the hashes of both images and of the audit events, the motion against its event, and the signature with the chain of keys.
opened-evidence-what-verify = Only with sightline verify: length, budget, gap, time of day and decision recomputed from boundary lines and rig, the verdict against its event, and the program of this page. The motion itself comes from the two complete strips, which the installation keeps.
opened-evidence-what-page = A file can be forged as a whole and would then state whatever its forger wants. If it matters, run sightline verify with the key shown by the installation.
opened-evidence-data = All data of this file
opened-evidence-decision = Decision
opened-evidence-decision-note = Rule: a decision is made only if the value is beyond the limit, on either side, by at least the guard band (JCGM 106:2012, 8.3), with the stated uncertainty taken as normally distributed.
opened-evidence-rule-source = The limit: { $source }
opened-evidence-motion = Motion as measured
opened-evidence-with-u = { $value } { $unit } (u = { $u } { $unit })
opened-evidence-speed = Speed as the front reaches camera 1
opened-evidence-acceleration = Acceleration
opened-evidence-length = Length
opened-evidence-direction = Direction
opened-evidence-direction-of = { $direction ->
    [camera_2_first] camera 2 first
   *[camera_1_first] camera 1 first
}
opened-evidence-lane-unknown = not known
opened-evidence-axles = Axles
opened-evidence-axles-of = { NUMBER($count) }, { $by ->
    [person] counted by a person
   *[machine] found by Sightline
}
opened-evidence-lines-1 = Front and rear at camera 1, line
opened-evidence-lines-2 = Front and rear at camera 2, line
opened-evidence-time-gap = Time gap to the vehicle in front
opened-evidence-distance-gap = Distance to the vehicle in front
opened-evidence-gap-none = no vehicle was measured in front of this one
opened-evidence-method = Measured
opened-evidence-found = Boundaries found by Sightline, { $method ->
    [paper] block matching
   *[direct] direct registration
  }; revision { $revision } of { $at } UTC, Sightline { $version }
opened-evidence-placed = Boundaries or wheels placed by a person, { $method ->
    [paper] block matching
   *[direct] direct registration
  }; revision { $revision } of { $at } UTC, Sightline { $version }
opened-evidence-review = Review
opened-evidence-verdict = { $verdict ->
    [accepted] Accepted by { $by } on { $at } UTC.
    [rejected] Rejected by { $by } on { $at } UTC.
    [reopened] Reopened by { $by } on { $at } UTC.
   *[to_review] Not reviewed yet.
  }
opened-evidence-budget = Uncertainty budget
opened-evidence-budget-note = Standard uncertainties; the last row is their root sum of squares.
opened-evidence-source = Source
opened-evidence-u-speed = u of the speed, m/s
opened-evidence-u-acceleration = u of the acceleration, m/s²
opened-evidence-u-length = u of the length, m
opened-evidence-combined = combined
opened-evidence-time = Time
opened-evidence-passed = Front at camera 1
opened-evidence-passed-u = { $at } (u = { $u_s } s)
opened-evidence-start = Confirmed start of the recording
opened-evidence-start-u = { $at }, local time in { $zone } (u = { $u_s } s)
opened-evidence-since = Since the first line
opened-evidence-clock-none = The start of this recording is not confirmed, so there is no time of day.
opened-evidence-rig = Rig and recording
opened-evidence-baseline = Baseline
opened-evidence-baseline-there = Baseline at the vehicle
opened-evidence-rate = Line rate
opened-evidence-divergence = Divergence of the scanning planes
opened-evidence-distance = Distance to the vehicles
opened-evidence-lane = Lane
opened-evidence-shadow = Shadow zone, lowest share of the rows
opened-evidence-misalignment = Misalignment in rows, as set
opened-evidence-strips = Recording
opened-evidence-strips-size = { $name }: { NUMBER($lines) } lines of { $rows } rows, { $bits } bits
opened-evidence-strip = SHA-256 of the stored strip of camera { $camera }
opened-evidence-audit = Audit trail
opened-evidence-audit-end = Chain { $chain } had { NUMBER($count) } events when this file was made. Its last hash was
opened-evidence-event = { $entity ->
    [scan_measurement] Motion { $number }
    [scan_review] Verdict { $number }
   *[scan] Recording { $number }
  }: { $action ->
    [create] created
    [read] imported
    [recorded] recorded
    [reading_failed] could not be imported
    [restart_reading] imported again
    [review] reviewed
    [swap_cameras] cameras swapped
   *[update] changed
  }
opened-evidence-pair = { $first }; { $second }
opened-evidence-event-number = No.
opened-evidence-event-at = At (UTC)
opened-evidence-event-what = Event
opened-evidence-event-hash = Hash
opened-evidence-keys = The installation’s keys up to the one that signed, each signed by the one before:
opened-evidence-pictures = Both images, and your own boundaries
opened-evidence-by-hand = Time runs to the right, one column per line. Choose front or rear, then click its position in each image; you can also enter lines in the fields below.
opened-evidence-set = { $edge ->
    [rear] Set the rear (blue)
   *[front] Set the front (yellow)
  }
opened-evidence-zoom = Zoom
opened-evidence-show-lines = Show the file’s boundaries (dashed)
opened-evidence-camera = Camera { $camera }
opened-evidence-quantity = Quantity
opened-evidence-hand = By your boundaries
opened-evidence-file = In the file
opened-evidence-line = { $edge ->
    [rear] Rear
   *[front] Front
  } at camera { $camera }, line
opened-evidence-plain-front = Speed of the front
opened-evidence-plain-rear = Speed of the rear
opened-evidence-plain = Your column uses the simple formula from two lines: speed = baseline / time between the cameras; length = mean of both speeds × time at camera 1. It differs from the server’s result, which registers all lines between and includes acceleration: the file’s speed is that when the front reaches camera 1.
opened-evidence-no-speed = these lines give no speed
opened-evidence-not-set = set all four boundaries
opened-evidence-no-shift = no speed
opened-evidence-speed-of = { $kmh } km/h ({ $mps } m/s)
opened-evidence-overlay = Camera 2 over camera 1
opened-evidence-shift = Move camera 2 back by (lines)
opened-evidence-opacity = Opacity of camera 2
opened-evidence-difference = Show the difference
opened-evidence-shift-hand = { $edge ->
    [rear] Align your rears
   *[front] Align your fronts
  }
opened-evidence-shift-file = { $edge ->
    [rear] Align the file’s rears
   *[front] Align the file’s fronts
  }
opened-evidence-shift-words = { $lines } lines are { $ms } ms; baseline / time gives { $speed }.

## Evidence of one line-scanned vehicle: its making, its decision, and its verification
evidence-no-rule = No limit was stated, so no decision was made.
evidence-decided = { $answer ->
    [conforming] Conforming
    [not_conforming] Not conforming
   *[undecided] Undecided
  }: the { $quantity ->
    [speed] speed
    [time_gap] time gap
   *[distance_gap] distance gap
  } is { $value } { $unit } with a standard uncertainty of { $u } { $unit }; the limit is { $side ->
    [upper] at most
   *[lower] at least
  } { $limit } { $unit }. { $answer ->
    [conforming] It is within the limit by at least the guard band of { $guard } { $unit } ({ $factor } u); the probability that this decision is wrong is { $least } { $chance } %, and { $risk } % was allowed.
    [not_conforming] It is beyond the limit by at least the guard band of { $guard } { $unit } ({ $factor } u); the probability that this decision is wrong is { $least } { $chance } %, and { $risk } % was allowed.
   *[undecided] It is closer to the limit than the guard band of { $guard } { $unit } ({ $factor } u); the more likely decision would be wrong with a probability of { $least } { $chance } %, and { $risk } % was allowed.
  }
evidence-none-refused = No decision: the vehicle has no measured motion. { $reason }
evidence-none-rig = No decision: values of the rig were changed after this vehicle, or the one in front of it, was measured.
evidence-none-review = No decision: { $verdict ->
    [rejected] a reviewer rejected the measurement.
    [reopened] a reviewer reopened the measurement, and it has not been accepted since.
   *[other] no reviewer has accepted the measurement.
  }
evidence-none-first = No decision: no vehicle was measured in front of this one, so there is no gap.
evidence-none-before = No decision: vehicle { $number }, in front of this one, has no motion measured with the current rig.
evidence-none-before-review = No decision: { $verdict ->
    [rejected] a reviewer rejected
    [reopened] no reviewer has accepted, since it was reopened,
   *[other] no reviewer has accepted
  } the measurement of vehicle { $number }, in front of this one.
evidence-none-value = No decision: there is no value with an uncertainty. { $reason }
evidence-not-measured = Vehicle { $number } is not measured; measure it first.
evidence-no-picture = The strip of camera { $camera } ends before the vehicle; place its front and rear within the strip.
evidence-too-long = Front and rear are { NUMBER($lines) } lines apart, more than a vehicle takes ({ NUMBER($most) }); correct its boundaries.
evidence-pages-not-built = The page of evidence files is not built; run make setup and try again.
evidence-one-limit = Give one limit: --most-kmh, --least-time-gap-s or --least-distance-gap-m, above 0 and below 10 000.
evidence-no-scan = The survey has no line-scan recording { $scan }; it has: { $names }.
evidence-scans-several = Several line-scan recordings of the survey are named { $scan }; give the number of one: { $numbers }.
evidence-no-vehicle = There is no vehicle { $number } in { $scan }; check the number on the line scan page.
evidence-not-one = This is not an evidence file as written by Sightline, or it was truncated; get the file again.
evidence-form = The part “{ $part ->
    [page] page and form
    [signature] signature and keys
    [pictures] images
    [events] audit events
    [derived] derived values
    [numbers] measured values
    [decision] decision
   *[said] sentences in other languages
  }” cannot be read ({ $words }); it was changed.
evidence-another-page = The page’s program is not the one named by the document; it was changed.
evidence-not-canonical = The document is not canonical JSON; it was changed.
evidence-signature = The signature is not valid for the document.
evidence-keys = The document does not show how its key follows from the earlier keys.
evidence-other-key = The file was signed with key { $key }, which is not linked to the given key; it is from another installation, or forged.
evidence-pictures = The two images, of camera 1 and camera 2, are not both there.
evidence-picture = The image { $name } is not the one named by the document.
evidence-picture-size = The image { $name } has another size than the document states.
evidence-event = Audit event { $number } is not the one that was hashed, or belongs to another chain.
evidence-no-event = There is no audit event of the { $part ->
    [before] vehicle in front
   *[measurement] measurement
  }.
evidence-not-as-event = The { $part ->
    [before] vehicle in front
   *[measurement] measurement
  } differs from its audit events: { $named }.
evidence-made-again = Recomputed from the document, this differs: { $named }.
evidence-numbers = For the { $part ->
    [before] vehicle in front
   *[measurement] measurement
  }, this does not follow from lines, rig and budget: { $named }.
evidence-page-other-version = The page was made by another version of Sightline: its hash is signed, but the page could not be compared with a page of this version.
evidence-words-other-version = Another version worded the decision, so its words were not compared; in the words of this one: { $words }
evidence-key-given = The signature proves what the holder of that key signed, not who held the key, nor that it is true, nor when it was made.
evidence-key-not-given = Signed with key { $key }: a forger can sign with a key of their own. Compare it with the key shown by the installation, or give that as --key.
statistics-risk-cannot-be = A risk of { $risk } is out of range; give { $least } to { $most }.

## A board to print

print-board-title = Checkerboard: { $columns } × { $rows } inner corners, squares of { $square_mm } mm
print-board-title-charuco = ChArUco board: { $columns } × { $rows } inner corners, squares of { $square_mm } mm, markers { $dictionary } of { $marker_mm } mm
print-board-check = Print on { $paper } at actual size (100 %), not fitted to the page. Then measure the bar above: it is { $bar_mm } mm long. If the print differs, measure a whole row of squares and enter the printed size of one square.
geometry-board-over-paper = The board needs a sheet of { $width_mm } x { $height_mm } mm including its white margin, which is larger than A0; choose squares of at most { $square_mm } mm, or name a roll of paper, such as 1200x900.
geometry-board-off-paper = The board needs a sheet of { $width_mm } x { $height_mm } mm including its white margin and does not fit on { $paper }; choose a larger paper, or squares of at most { $square_mm } mm.
geometry-paper-not-known = Paper { $paper } cannot be used; give one of { $papers }, or its width and height in mm, each { $least_mm } to { $most_mm }, such as 841x1500.

# Reference values of scanned vehicles, said or imported
reference-value-cannot-be = A reference { $quantity } of { $value } { $unit } is out of range; give a value above { $least } and up to { $most } { $unit }.
reference-u-cannot-be = An uncertainty of { $u } { $unit } for a { $quantity } of { $value } { $unit } is out of range; give a standard uncertainty above 0 and not above the value itself.
reference-device-too-long = The instrument’s name is longer than { $most } characters; shorten it.
reference-withdrawn-already = This reference value was already removed; there is nothing to do.
reference-changed-meanwhile = { $name } changed this reference value meanwhile; check it first.
reference-columns-missing = { $name } needs a column “number” (of the vehicle in its recording) or “time” (at which it passed) and one of speed_kmh, length_m, wheelbase_m or run_of; its first line must name the columns.
reference-column-unit = The column “{ $column }” of { $name } does not state its unit; name it one of { $names }, with “u_” in front for the uncertainty.
reference-columns-of-one = The columns “{ $first }” and “{ $second }” of { $name } state the same; leave one out.
reference-no-rows = { $name } has a header and no line of reference values below it; add one.
reference-no-line-used = No line of { $name } can be used; line { $line }: { $reason }
reference-line-no-number = The vehicle number is “{ $number }”; give the whole number shown on the line scan page.
reference-line-no-vehicle = This recording has no vehicle { $number }.
reference-line-no-u = The { $quantity } has no uncertainty; give u_{ $quantity } beside it.
reference-line-no-value = There is an uncertainty of the { $quantity } but no { $quantity }.
reference-line-no-source = The source is “{ $source }”; use one of { $known }.
reference-line-empty = The line gives no value and no car.
reference-line-twice = Line { $line } gives the { $quantity } of this vehicle by { $source } already.
reference-line-no-time = “{ $text }” is not a time with seconds; write it as 14:05:32.4 or 2025-05-14T14:05:32.4.
reference-line-no-date = The recording continues into another day, on which { $time } occurs again; give the date too.
reference-line-nobody = No vehicle of this recording has a time of day, so none passed within { $tolerance_s } s of { $time }.
reference-line-nobody-near = No vehicle passed within { $tolerance_s } s of { $time }; the nearest is vehicle { $number }, { $apart_s } s away.
reference-line-several = Vehicles { $numbers } passed within { $tolerance_s } s of { $time }; give the number of the right one.
reference-line-fits-others = By its time this is vehicle { $number }, but line { $lines } gives its { $quantity } by { $source } too; give the vehicles’ numbers.
reference-line-fits-cars = By its time this is vehicle { $number }, but line { $lines } names another car for it; give the vehicles’ numbers.
reference-vehicle-without-time = Vehicle { $number } has no time of day to compare with; leave the time out.
reference-time-of-another = Vehicle { $number } passed { $apart_s } s from this time, more than { $tolerance_s } s.
reference-times-need-start = { $name } has times, but the start of this line scan is not confirmed, so no vehicle has a time of day. Confirm the start, or give the vehicles’ numbers.
reference-times-later = The times of { NUMBER($count) } lines are { $off_s } s later (median) than those of their vehicles.
reference-times-earlier = The times of { NUMBER($count) } lines are { $off_s } s earlier (median) than those of their vehicles.
reference-times-start = The U95 of the start of this line scan is { $U95_s } s, more than the tolerance of { $tolerance_s } s: a line may fit a neighbouring vehicle. Check the pairs.
reference-unit-doubtful = The { $quantity ->
    [speed] speed
    [length] length
   *[wheelbase] wheelbase
} of { NUMBER($count) } { $count ->
    [one] line
   *[other] lines
} is about { NUMBER($times, maximumFractionDigits: 2) } times ours: check the unit that the name of its column states.
reference-line-replaces = Replaces the { $quantity } { $value } { $unit } (u = { $u } { $unit }).
reference-line-renames = Was a run of { $car }.
reference-car-too-long = The car’s name is longer than 100 characters; shorten it.
scans-reference-differs = { $path }: { $name } of row { $number } does not follow from the reference and the vehicle’s own value.
## Said: motions, gaps and runs of line scans

scan-motion-lane-unknown = The lane is not known ({ $why }): the uncertainties cover every lane of its direction; choose its lane.
scan-lane-no-wheel = no wheel that identifies the lane was found
scan-lane-not-this-way = no lane of the rig has this direction
scan-lane-other-rows = its tyres meet the road at row { $row }, { $lanes ->
    [0] in no lane’s rows
   *[other] in the rows of several lanes
 }
scan-gap-lane-unknown = Its lane is not known, so the vehicle in front of it is not known either.
scan-gap-before-unknown = A vehicle of unknown lane passed in front of it, perhaps in this lane.
scan-gap-none-before = No vehicle was detected in front of this one.
scan-gap-overlap = The two vehicles overlap at camera 1, so there is no gap.
scan-gap-other-rate = The two vehicles were measured at different line rates; measure both again.
scan-gap-leader-unmeasured = The vehicle in front has no measured motion.
scan-gap-rear-unseen = The rear of the vehicle in front was not seen: it stood in view for too long.
scan-gap-leader-stopped = At the measured deceleration, the vehicle in front would have stopped by then.
scan-motion-too-coarse = The lines are too far apart for this vehicle: it moves about { $line_mm } mm from line to line, so neighbouring lines have too little in common. Raise the line rate to { $rate_hz } Hz or more for vehicles at this speed; a longer baseline does not help.
scan-no-wheel = No wheel was found: the lower part of the image shows none, or is too dark.
scan-no-scale = Without a motion the image has no scale in metres.
scan-motion-implausible = The computed { $what ->
    [speed] speed
    [length] length
   *[acceleration] acceleration
 } of { NUMBER($value, minimumFractionDigits: 1, maximumFractionDigits: 1) } { $unit } is not plausible for a road vehicle ({ $low } to { $high } { $unit }): check the boundaries, the baseline and the line rate.
scan-motion-no-uncertainty = Too little of the vehicle was matched to state the uncertainty of its motion: check the boundaries in both images.
scan-motion-would-stop = By the computed motion the vehicle would have stopped in view; check the boundaries.
scan-motion-u-large = The U95 of the { $what ->
    [speed] speed
   *[length] length
 } is { $percent } %, too large to be useful: too little of the vehicle is clear, the boundaries are wrong, or two vehicles pass at once.
scan-motion-u-acceleration-large = The U95 of the acceleration is { $U95_mps2 } m/s², more than any vehicle’s braking: too little of the vehicle is clear, or the boundaries are wrong.
scan-motion-no-order = The boundaries are not in order: the front must come before the rear at both cameras.
scan-motion-no-texture = Too little of the vehicle is clear enough to be registered between the strips. Check the boundaries; if they are right, record with more contrast: focus, light or exposure.
scan-motion-no-match = The two images of the vehicle do not fit one motion: two vehicles side by side, a vehicle that stopped, or lost lines. Check the boundaries at both cameras; if they are right, leave it unmeasured.
scan-motion-few-lines = Only about { $lines } lines were recorded between the two cameras, too few for its speed or direction: raise the line rate, or set the cameras further apart.
scan-motion-few-blocks = Too few blocks of { $lines } lines can be matched: the vehicle has too little detail, or too few lines; raise the line rate, or use the other method.
scan-motion-not-converged = The registration of the two images stopped before it settled: speed, acceleration and length may be off by more than their uncertainties say. Check the boundaries in both images; if the warning stays, reject the vehicle.
scan-motion-cameras-disagree = The cameras disagree by { $apart_cm } cm about the front or the rear: check the boundaries, and whether two vehicles pass side by side.
scan-motion-saturated = Part of the image is saturated; reduce the exposure.
scan-motion-stopped = The vehicle stopped or nearly stopped in view; mark another vehicle, or measure it by hand.
scan-motion-stood = The vehicle stood in view for so long that its rear was not seen; measure it by hand.
scan-motion-too-long-in-view = Something was in view for longer than a vehicle takes to pass: it stopped, or the light changed. Look at both strips: remove it if it is no vehicle, or place its boundaries by hand.
scan-motion-cut = The vehicle is cut off by the beginning or the end of the recording. If both its ends are in the strips, place its boundaries by hand; begin and end recordings on an empty road.
scan-motion-no-road = The empty road before the vehicle is too unsteady: snow, rain, or traffic from the first line on; start to record while the road is empty.
scan-motion-too-long = Its estimated length is { $length_m } m, and the limit is { $most_m } m: a train, vehicles without a gap, or a wrong baseline or line rate.
scan-motion-two-at-once = The cameras show it for different durations: two vehicles pass side by side, or it stopped.
scan-motion-lines-lost = The recorder lost { $lost } while the vehicle passed. This passage cannot be measured; find out why the recorder loses lines before you record again.
scan-lines-of-camera = { NUMBER($count) } lines of camera { $camera }
words-both = { $first } and { $second }
scan-motion-no-wheelbase = No wheelbase: { $reason }
scan-wheelbase-no-motion = The vehicle has no measured motion.
scan-wheelbase-one-wheel = Click the hubs of two different wheels.
scan-wheelbase-at-rest = By its fitted motion the vehicle was at rest at one of the clicks.
scan-run-none-found = No vehicle was found; check the strips, and that time runs along the chosen axis.
scan-run-swapped = { NUMBER($reversed) } of { NUMBER($found) } vehicles reached the second strip first; if traffic does not run that way here, the strips are swapped.
scan-run-alone = { $alone } objects passed only one camera: check that both show the same lane, and check baseline and line rate.
scan-run-stood-in-front = A vehicle stopped in front of another that stood; it may be missing, and so may vehicles that passed meanwhile.
scan-run-rests-again = { $count ->
    [one] Once something came to rest in front of a standing vehicle. It
   *[other] { NUMBER($count) } times something came to rest in front of a standing vehicle. Each
 } counts as another vehicle, but may be the same one that moved on a little: look at the strips.
scan-run-light-changed = The brightness changed suddenly { $count ->
    [one] once
   *[other] { NUMBER($count) } times
 }; vehicles that passed at that moment may be missing.
scan-run-camera-moved = A camera moved { $count ->
    [one] once
   *[other] { NUMBER($count) } times
 }: the road is some rows higher or lower since then; fix the camera firmly.
scan-run-road-unsteady = The empty road of camera { $camera } varies by { $percent } % from line to line: snow, rain, or a vehicle at the start; record the empty road first.
scan-run-short-objects = Camera { $camera } shows { $per_s } short objects a second: rain, snow or insects; check the boundaries.
scan-run-flicker = The light at camera { $camera } flickers by { $percent } %, as mains lighting does; use other lighting, or expect larger uncertainties.
scan-run-saturated = { $percent } % of the image of camera { $camera } is saturated; reduce the exposure.
rig-misalignments-scatter = The misalignment differs between vehicles by { NUMBER($sd_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px (standard deviation); check whether a camera moved.
rig-few-known = { NUMBER($count) } known vehicles are too few; { $least } are needed.
rig-misalignment-given = The misalignment was entered, so the estimates of the vehicles depend on it; leave it empty and measure again to have it estimated.
rig-baseline-off = { NUMBER($count) } { $of ->
    [length] lengths
   *[wheelbase] wheelbases
 } of known vehicles measure { NUMBER($percent, minimumFractionDigits: 2, maximumFractionDigits: 2) } % { $than ->
    [longer] longer
   *[shorter] shorter
 } than they are (u = { NUMBER($u_percent, minimumFractionDigits: 2, maximumFractionDigits: 2) } %): a { $than ->
    [longer] shorter
   *[shorter] longer
 } baseline would fit. Check the baseline.{ $of ->
    [length] { " " }Shadows can also add length; wheelbases are free of them.
   *[wheelbase] { "" }
 }
rig-baseline-agrees = { NUMBER($count) } { $of ->
    [length] lengths
   *[wheelbase] wheelbases
 } of known vehicles are off by { NUMBER($off_percent, minimumFractionDigits: 2, maximumFractionDigits: 2) } % on average, within the U95 of this mean ({ NUMBER($U95_percent, minimumFractionDigits: 2, maximumFractionDigits: 2) } %).
scan-flow-no-speed = No vehicle here has an accepted speed.
scan-flow-rear-unseen = The occupancy is not known: the rear of a vehicle that stood here was not seen.
scan-flow-no-u-occupancy = The uncertainty of the occupancy is not known: { NUMBER($count) } of the vehicles here have no accepted speed.
stream-lines-lost = { NUMBER($count) } lines of camera { $camera } were lost and replaced by copies; vehicles that passed meanwhile are not measured.
stream-vehicles-wait = { $message } { NUMBER($waiting) } vehicles wait to be stored in the survey.
stream-recording-deleted = { $recording } was deleted while it was streamed: none of its vehicles are stored from now on, and both strips are deleted at its end.
stream-recording-not-there = { $recording } was not found in this survey: none of its vehicles are stored from now on.
stream-refused = { $message } Nothing more is stored in the survey by this run; vehicles are still printed.
stream-strip-changed = { $name } does not arrive as it was sent; check whether another program writes to it.
stream-strips-kept = The strips of { $recording } stay in { $first } and { $second }; the next stream with this folder tries again to store them.
stream-stopped = The previous run was stopped after { NUMBER($lines) } lines (segment { $number }, last contact { $last_at } UTC). Its vehicles are kept; missing are the { NUMBER($gap_s, minimumFractionDigits: 1, maximumFractionDigits: 1) } s (about { NUMBER($gap_lines) } lines) since then, and the vehicle that was in view.
stream-resumed = The previous run was stopped; it is resumed at line { $begin } of { $name }, and nothing is missing.
stream-clock-set = The computer’s clock was set by { NUMBER($jump_s, minimumFractionDigits: 1, maximumFractionDigits: 1) } s at line { $lines }; speeds, lengths and gaps are not affected, and times of day continue from the start of this segment.
stream-lines-not-stored = Later lines could not be stored ({ $strerror }); they were measured nevertheless.
stream-journal-not-written = The journal could not be written ({ $strerror }).
stream-lines-stored = { NUMBER($kept) } lines are stored in { $path }.
rig-few-vehicles = { NUMBER($count) } vehicles give a { $of ->
    [misalignment] misalignment
   *[gain] gain
 }; { $least } are needed.
scan-motion-not-finite = The computed { $what ->
    [speed] speed
    [length] length
   *[acceleration] acceleration
 } is not a number: check the boundaries, the baseline and the line rate.

## Said: boards, calibrations, camera poses and the traffic's say on them

board-not-found = No board was found.
board-search-stopped = The search was stopped.
board-none = No board of { $columns }x{ $rows } inner corners was found; show the whole board with its white margin, sharp and evenly lit, and count the inner corners.
board-none-in-time = No board of { $columns }x{ $rows } inner corners was found before the time limit of the search; show the whole board with its white margin, sharp and evenly lit, and count the inner corners.
board-cut-off = The board is cut off by the edge of the image; show the whole board.
board-squares-tiny = The squares are smaller than 3 px; bring the board closer or use larger squares.
board-markers-tiny = The squares are smaller than 3 px; bring the board closer.
board-no-checkerboard = The pattern found does not consist of alternating squares.
board-picture-too-small = The image is too small to contain a board.
board-none-with-markers = No ChArUco board of { $columns }x{ $rows } inner corners with { $dictionary } markers was found, or too little of it; it must be sharp and of that dictionary.
board-goes-on = The board continues { $side ->
    [left] to the left
    [right] to the right
    [above] above
   *[below] below
 } beyond { $columns }x{ $rows } inner corners; count its inner corners again.
board-corners-uneven = The corners found do not form an even grid; something covers the board or it is not flat.
board-moved-far = The board moved too far between two frames.
board-no-frame = No frame was given.
board-corners-few = At most { $parts } of its { $whole } corners were found; show the whole board.
board-order = Corners are numbered from the top left as seen, along the rows to the right and then down.
board-order-part = { $seen } of its { $all } corners are visible: enough for a calibration; a camera pose needs all of them.
board-order-turned = The board is rotated: { $columns } columns by { $rows } rows as seen, not as entered.
pose-frames-without-board = The board was not found in { $missed } of the frames; these are not used.
pose-frames-moved = Board or camera moved in some of the frames; only frames at rest are used.
pose-corners-miss-model = The corners fit the model to { NUMBER($rms_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px only; the board may be bent or the lens calibration poor.
pose-two-fit = Two poses fit the board almost equally well; turn the camera by some 30 degrees along the road, or bring the board closer.
pose-squares-small = The squares are small in the image; bring the board closer.
pose-board-rolled = The board appears rolled by { $roll_deg } degrees; check that columns and rows were not exchanged.
pose-image-twice = { $name } is the same image as { $file }; it counts once.
pose-frames-twice = { $count ->
    [one] { NUMBER($count) } frame of { $name } was given before; it counts once.
   *[other] { NUMBER($count) } frames of { $name } were given before; they count once.
}
pose-one-frame = Only one frame is used, so it is not checked that the board was at rest.
pose-road-turned = Rotated by { NUMBER($heading_deg, minimumFractionDigits: 2, maximumFractionDigits: 2) } degrees to the travel direction.
pose-turned-by-vehicles = Rotated by { NUMBER($turn_deg, minimumFractionDigits: 2, maximumFractionDigits: 2) }° to the direction of { NUMBER($vehicles) } vehicles.
pose-adjusted-by-passes = Adjusted by { NUMBER($passes) } passes of known wheelbase or height.
pose-before = The previous pose is number { $pose }.
pose-simulated = Simulated.
pose-board-distance = The board was { NUMBER($distance_m, minimumFractionDigits: 2, maximumFractionDigits: 2) } m from the camera.
pose-camera-height = The camera is { NUMBER($height_m, minimumFractionDigits: 2, maximumFractionDigits: 2) } m above the road.
pose-expected-heights = Expected U95 of a height of 1.2 m, without the inset’s part, clicked with u = 1 px: { $figures }.
pose-expected-at = ± { SMALL($U95_height_m) } at { $distance_m } m
pose-no-road-at-distance = The image does not show the road at this distance.
words-comma = { $first }, { $second }
calibration-image-other-size = The image is { $width_px }x{ $height_px } px, most of the others are { $usual_width_px }x{ $usual_height_px } px.
calibration-image-blurred = The image is blurred (edges { NUMBER($edge_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px wide).
calibration-image-twice = The image is the same as { $file }; take every view once.
calibration-no-covariance = The file states no uncertainty of the lens, so that component is missing from the uncertainty of every height.
calibration-made = { $used } of { $given } views used, residual { NUMBER($rms_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px, focal length { NUMBER($focal_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px.
calibration-made-u = { $used } of { $given } views used, residual { NUMBER($rms_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px, focal length { NUMBER($focal_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px (standard uncertainty { NUMBER($u_focal_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px).
calibration-imported = Imported from { $file_name }: { $model } model, focal length { NUMBER($focal_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px.
calibration-board-bent = The board is not flat: it bends by about { NUMBER($bow_percent, minimumFractionDigits: 1, maximumFractionDigits: 1) } % of a square; modelling its shape lowers the residual from { NUMBER($flat_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } to { NUMBER($bent_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px. Fix the board to a stiff, flat plate and retake the images, or calibrate with “May be bent”.
calibration-board-bent-changes = The board is not flat: it bends by about { NUMBER($bow_percent, minimumFractionDigits: 1, maximumFractionDigits: 1) } % of a square; modelling its shape lowers the residual from { NUMBER($flat_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } to { NUMBER($bent_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px and a height at { $distance_m } m changes by { SMALL($change_m) }. Fix the board to a stiff, flat plate and retake the images, or calibrate with “May be bent”.
calibration-halves-few = Two halves need at least { $least } usable views{ $board ->
    [bent] { " " }of a bent board
   *[flat] { "" }
 }; there are { $usable }. Add images.
calibration-halves-failed = The two halves could not be calibrated separately: { $message }
calibration-halves-no-inverse = A board lies where the lens model has no inverse; add images that reach the corners.
calibration-halves-differ = Two halves of the images, calibrated separately, differ by { SMALL($difference_m) } in a height at { $distance_m } m: more than the corners’ noise explains. The lens may need the other model, the board may be bent, or zoom or focus changed between images.
calibration-halves-differ-beyond = Two halves of the images, calibrated separately, differ by { SMALL($difference_m) } in a height at { $distance_m } m, { SMALL($expected_m) } expected: more than the corners’ noise explains. The lens may need the other model, the board may be bent, or zoom or focus changed between images.
calibration-held-out-worse = Held-out images fit the lens much worse than fitted images ({ NUMBER($held_out_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px against { NUMBER($fit_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px); add images with the board tilted and in every part of the image.
calibration-few-views = Only { NUMBER($count) } views were used; with fewer than { $few } a small residual proves little; use 15 to 25.
calibration-views-alike = Only { $different } of the { NUMBER($count) } views differ because the board hardly moved between the others; move and tilt it between images, or use frames further apart.
calibration-little-covered = The boards cover { $percent } % of the image; add views that reach its edges and corners, where the distortion is largest.
calibration-boards-parallel = All board views have the same orientation, so focal length and distance cannot be separated; tilt the board by 30 to 45 degrees in several directions.
calibration-residual-high = The residual of { NUMBER($rms_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px is high; the board may not be flat, its size may be wrong, or the lens needs another model.
calibration-other-model-better = The { $model } model fits better ({ NUMBER($other_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px against { NUMBER($rms_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px); calibrate with that model.
calibration-lens-undetermined = The views do not determine the lens; its uncertainty cannot be stated.
calibration-focal-vague = The focal length is known to { NUMBER($percent, minimumFractionDigits: 1, maximumFractionDigits: 1) } % only; add views, tilted and near.
lens-axis-off-middle = The optical axis lies far from the middle of the image; was the image cropped?
lens-pixels-not-square = The two focal lengths differ by more than 10 %; are the pixels square?
lens-no-inverse-in-corners = The lens model cannot be inverted in the corners of the image, so nothing is measured there; add images that reach the corners.
calibration-squares-small = In { $small } of { $views } views the squares are smaller than { $least_px } px and their corners inexact; bring the board nearer or use larger squares.
calibration-several-sizes = Images of several sizes: { NUMBER($count) } skipped that are not { $width_px }x{ $height_px } px ({ $file } first); a calibration applies to one size only, so use images of the recordings’ size.
calibration-board-seldom = The board was used in only { $used } of { $given } images; count its inner corners again, and show the whole board, sharp and evenly lit.
calibration-image-outlier = { $file } fits much worse than the others ({ NUMBER($rms_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px against { NUMBER($usual_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px); check its corners.
calibration-tilt-edge = Tilt the board by about 30 degrees, its { $edge } edge nearer the camera.
calibration-tilt-edges = Tilt the board by about 30 degrees, its { $edges } edge in turn nearer the camera.
board-edge = { $edge ->
    [left] left
    [right] right
    [top] top
   *[bottom] bottom
 }
image-part = { $place ->
    [top-left] top left
    [top-centre] top centre
    [top-right] top right
    [middle-left] middle left
    [middle-right] middle right
    [bottom-left] bottom left
    [bottom-centre] bottom centre
    [bottom-right] bottom right
   *[middle-centre] centre
 }
calibration-bring-nearer = Bring the board nearer: it never fills more than { $percent } % of the image; a third or more is good.
calibration-hold-in = Hold the board in the { $parts } of the image.
import-several-cameras = { $file_name } contains several cameras: { $cameras }; { $key } was read (name another with --which).
import-roi-whole = { $file_name }: the camera is that of the whole image, as requested, not of its roi.
import-roi-part = { $file_name } describes part of the image (roi): { $width }x{ $height } px from ({ $left }, { $top }) of { $full_width }x{ $full_height } px; the camera is that of the part (--size { $full_width }x{ $full_height } for the whole).
import-no-distortion = { $file_name } states a lens without any distortion, which is rare; check that this camera was calibrated.
import-model-guessed = { $file_name } does not name its distortion model; its four coefficients were read as { $taken } (choose with --model).
adjustment-length-not-finite = The { $length ->
    [wheelbase] wheelbase
    [roof] roof
   *[roof_inset] roof inset
 } or its uncertainty is not a finite number, or the uncertainty is negative.
adjustment-length-not-positive = The { $length ->
    [wheelbase] wheelbase
    [roof] roof
   *[roof_inset] roof inset
 } is not positive.
adjustment-length-off = Its { $length ->
    [wheelbase] wheelbase
    [roof] roof
   *[roof_inset] roof inset
 } of { NUMBER($known_m, minimumFractionDigits: 3, maximumFractionDigits: 3) } m is { NUMBER($deviate, minimumFractionDigits: 1, maximumFractionDigits: 1) } standard uncertainties too { $than ->
    [long] long
   *[short] short
 } for the observed points; check the model.
adjustment-crooked = Too many of its points are off a straight line.
adjustment-point-outside = A point lies outside the frame.
adjustment-tyre-off-road = A tyre lies where there is no road: above the horizon, or outside the lens model’s radius.
adjustment-part-excluded = The traffic contradicts the { $part ->
    [board_lean_rad] { adjust-moved-board_lean_rad }
    [board_roll_rad] { adjust-moved-board_roll_rad }
    [board_height_m] { adjust-moved-board_height_m }
    [square_m] { adjust-moved-square_m }
    [bow_along_rows_m] { adjust-moved-bow_along_rows_m }
    [bow_down_columns_m] { adjust-moved-bow_down_columns_m }
    [wheelbase_common_m] { adjust-moved-wheelbase_common_m }
   *[roof_common_m] { adjust-moved-roof_common_m }
 } with its stated u of { $u } { $unit }; it was excluded.
adjustment-common-far-off = One value is far from 0 for its stated u of { $u } { $unit }: the { $part ->
    [board_lean_rad] { adjust-moved-board_lean_rad }
    [board_roll_rad] { adjust-moved-board_roll_rad }
    [board_height_m] { adjust-moved-board_height_m }
    [square_m] { adjust-moved-square_m }
    [bow_along_rows_m] { adjust-moved-bow_along_rows_m }
    [bow_down_columns_m] { adjust-moved-bow_down_columns_m }
    [wheelbase_common_m] { adjust-moved-wheelbase_common_m }
    [roof_inset_common_m] { adjust-moved-roof_inset_common_m }
   *[roof_common_m] { adjust-moved-roof_common_m }
 }. Check that the known lengths refer to the points that were followed.
adjustment-points-scatter = The points scatter { NUMBER($factor, minimumFractionDigits: 1, maximumFractionDigits: 1) } times as much as stated; their uncertainties were multiplied by this factor.
adjustment-lengths-scatter = The known values of the { $length ->
    [wheelbase] wheelbase
    [roof] roof
   *[roof_inset] roof inset
 } scatter { NUMBER($factor, minimumFractionDigits: 1, maximumFractionDigits: 1) } times as much as stated; their uncertainties were multiplied by this factor.
adjustment-global-test-failed = Global test failed: chi-square { $chi2 } with { $freedom ->
    [one] 1 degree
   *[other] { NUMBER($freedom) } degrees
 } of freedom; the stated uncertainties are not consistent.
adjustment-few-vehicles = With { NUMBER($count) } vehicles, a wrong vehicle cannot be distinguished from a wrong pose.
adjustment-pose-unchanged = No pass with a known length could be used, so the pose is unchanged.
adjustment-point-not-finite = A point or its uncertainty is not a finite number.
adjustment-point-no-u = The uncertainty of a point is below 0.001 px.
adjustment-point-twice = A point is given twice on one frame.
adjustment-no-tyre = No tyre of this vehicle was measured, so it is not tied to the road.
adjustment-no-known-length = No known length of this vehicle was measured.
adjustment-no-model = Its make and model are not filled in, so its wheelbase is unknown.
adjustment-no-wheelbase = The catalogue has no wheelbase of this model and year.
adjustment-several-wheelbases = The catalogue has several wheelbases of this model; fill in the year.
adjustment-no-height = The manufacturer’s height is not filled in.
adjustment-model-by-size = Its model was chosen by its sizes, so what is known of the model is no reference.
adjustment-roof-not-near-edge = The roof was not clicked at its near edge.
adjustment-no-lengths-yet = No lengths are known yet: click both tyres of vehicles of a known model, or measure their roofs.
adjustment-done-before = This pose is already adjusted to the traffic.
adjustment-no-pass = No pass with a known length could be used.
traffic-turned = The road’s X axis is rotated by { NUMBER($mean_deg, minimumFractionDigits: 2, maximumFractionDigits: 2) }° (u = { NUMBER($u_deg, minimumFractionDigits: 2, maximumFractionDigits: 2) }°, { NUMBER($count) } vehicles) against the traffic.
traffic-agrees = The road’s X axis agrees with the traffic: rotated by { NUMBER($mean_deg, minimumFractionDigits: 2, maximumFractionDigits: 2) }° (u = { NUMBER($u_deg, minimumFractionDigits: 2, maximumFractionDigits: 2) }°, { NUMBER($count) } vehicles), not significant.
traffic-turn-changes = This changes { NUMBER($count) } stored heights by up to { SMALL($largest_m) }.
traffic-turn-would-change = Rotating it would change stored heights by up to { SMALL($largest_m) }.
traffic-few-vehicles = Both tyre contacts of at least { $least } vehicles are needed; { $usable } can be used.
adjustment-row-frame = Row { $row }: the cell frame is not a whole number.
adjustment-row-point = Row { $row }: the cell point is none of { $points }.
adjustment-row-another = Row { $row }: another { $column } was given for the same pass.
adjustment-u-lacking = { $given } is given without { $lacking }.

## Said: insets, repeats and models that fit

inset-few-known = At least { $least } vehicles of known height are needed; { $usable } can be used.
inset-known-at-camera-height = Not conclusive: the vehicles are at about camera height, where the inset has little effect.
inset-none-fits = No inset fits the manufacturers’ heights; check them, the camera’s height and the clicks.
inset-known-vague = Not conclusive: too few vehicles, or heights too near the camera’s or too uncertain.
inset-few-trend = At least { $least } vehicles are needed; { $usable } can be used.
inset-no-trend = The inset cannot be estimated: too few vehicles, or all at about the same distance.
inset-trend-at-camera-height = Not conclusive: this target is at about camera height, where the inset has little effect.
inset-trend-one-distance = Not conclusive: all passed at about the same distance, { NUMBER($nearest_m, minimumFractionDigits: 1, maximumFractionDigits: 1) } to { NUMBER($farthest_m, minimumFractionDigits: 1, maximumFractionDigits: 1) } m.
inset-trend-few = Not enough data: a few hundred vehicles are needed for u = 0.15 m.
inset-few-solved = At least { $least } vehicles measured on two frames are needed; there are { NUMBER($count) }.
inset-solved-close-frames = Not conclusive: the frames were close together.
inset-no-gain = Agrees with the current inset; using it would make no height more certain.
inset-no-known-roof = No vehicle with a manufacturer’s height has a measured roof.
inset-nothing-measured = No measurements of this target.
repeat-first-no-height = The first clicks give no height: { $reason }
repeat-second-no-height = The second clicks give no height: { $reason }
repeat-other-frame = They were clicked on different frames, so not only the clicks differ.
repeat-other-pose = The camera pose changed since, so not only the clicks differ.
repeat-other-inset = The insets differ, so not only the clicks differ.
repeat-no-uncertainty = A height has no uncertainty.
repeats-few-own = { $name } has { $pairs } own repeats; { $least } are needed.
repeats-few-other-frame = Needs { $least } repeats on another frame, has { NUMBER($count) }.
repeats-nothing-yet = No repeat measurements yet.
repeats-few = Too few repeats: { $freedom ->
    [one] 1 degree
   *[other] { NUMBER($freedom) } degrees
 } of freedom, at least { $least } are needed.
repeats-few-to-compare = Too few repeats to compare: { $freedom }, at least { $least } are needed.
repeats-one-operator = No target was repeated by a second operator; ask another operator to repeat some.
repeats-no-difference = No difference between operators can be detected; add repeats to narrow the estimate.
models-none-in-catalogue = The catalogue is empty.
models-none-of-year = No model in the catalogue was built in { $year }.
models-none-fits = No model in the catalogue fits what was measured on this vehicle.
models-nothing-measured = No size in the catalogue has been measured on this vehicle yet.
models-no-such-size = No model in the catalogue has a size that was measured on this vehicle.

## Said: what an import notes of a video or of strips

video-filmed-at = Filmed at { $filmed_hz } frames per second, as entered; the file plays { $played_hz } per second. Times are those of filming.
video-no-rate = The file states no frame rate: { $played_hz } frames per second are assumed. Its times are unreliable, so no motion is measured from them.
video-impossible-rate-endless = The time stamps give infinitely many frames per second, which no camera films. Its times are unreliable, so no motion is measured from them.
video-impossible-rate = The time stamps give { $played_hz } frames per second, which no camera films. Its times are unreliable, so no motion is measured from them.
video-slow-motion = The file is marked as slow motion; it plays { $played_hz } frames per second. Heights from single frames are valid, but no motion is measured until you enter the filming rate.
video-slow-motion-at = The file states that it was filmed at { $filmed_hz } frames per second; it plays { $played_hz } frames per second. Heights from single frames are valid, but no motion is measured until you enter the filming rate.
video-gaps = Frames are missing: { $count ->
    [one] one gap
   *[other] { NUMBER($count) } gaps
 }, the longest { NUMBER($gap_s, minimumFractionDigits: 2, maximumFractionDigits: 2) } s after frame { $frame }.
video-truncated = The file is truncated: { NUMBER($missing) } bytes are missing at its end. { NUMBER($count) } frames ({ NUMBER($span_s, minimumFractionDigits: 2, maximumFractionDigits: 2) } s) were imported; copy it again for the rest.
video-another-recording-after = The file contains another recording after this one, which is not imported. Split the file and add each part.
video-other-tracks = The file contains { $count ->
    [one] another video track
   *[other] { NUMBER($count) } other video tracks
 }: { $others }; track { $stream } ({ $codec }, { $width_px }x{ $height_px }) was imported.
video-track = { $number } ({ $codec }, { $width_px }x{ $height_px }{ $kind ->
    [still] , a still image
    [off] , disabled
    [still_off] , a still image, disabled
   *[moving] { "" }
 })
video-track-unknown = { $number } (unknown codec)
video-not-turned = The header asks for a further rotation by { $degrees } degrees, which is not applied: only quarter turns keep the pixels as filmed.
video-same-image = { NUMBER($count) } { $count ->
    [one] frame has
   *[other] frames have
 } the same image as the one before.
video-not-later = { NUMBER($count) } { $count ->
    [one] frame has
   *[other] frames have
 } a time stamp not later than the one before; the times were sorted.
video-packets-damaged = { NUMBER($count) } damaged { $count ->
    [one] packet was
   *[other] packets were
 } skipped; frames are missing there.
video-frames-patched = { NUMBER($count) } { $count ->
    [one] frame is
   *[other] frames are
 } damaged and completed by the decoder, the first one at { $first }; do not measure there.
video-start-in-future = The file states a start of { $start } UTC, which is in the future: the camera’s clock is wrong, so no start is suggested.
video-ends-early = The header states { NUMBER($duration_s, minimumFractionDigits: 1, maximumFractionDigits: 1) } s, the frames end after { NUMBER($end_s, minimumFractionDigits: 1, maximumFractionDigits: 1) } s; the file may be truncated.
video-other-rate = The header states { $stated_hz } frames per second, the time stamps give { $rate_hz }; the time stamps are used.
video-other-count = The header states { NUMBER($claimed) } frames, { NUMBER($count) } could be decoded; frame numbers refer to these.
video-shown-upright = The frames were { $done }, as their header states.
video-stretched = stretched for pixels of { $aspect }
video-turned = turned by { $degrees } degrees clockwise
video-mirrored = mirrored
video-interlaced = The recording is interlaced: moving edges are combed, prefer a progressive recording.
video-working-copy = Frames are served from a working copy with an index; they are identical to the original’s.
video-other-size-skipped = { NUMBER($count) } frames of another size were skipped.
video-rate-varies = The frame rate varies: { NUMBER($least_s, minimumFractionDigits: 4, maximumFractionDigits: 4) } to { NUMBER($most_s, minimumFractionDigits: 4, maximumFractionDigits: 4) } s between frames; times come from the time stamps.
video-unreadable-end = The file could not be read to its end; { NUMBER($count) } frames were found before that.
video-no-time-stamps = The stream contains no usable time stamps: { $rate_hz } frames per second are assumed, so its times are unreliable.
scan-pixels-saturated = { $percent } % of camera { $camera }’s pixels are saturated, so edges are lost there; reduce the light or the exposure.
scan-recorder-lost = The recorder of { $name } lost { NUMBER($count) } lines; they were replaced by copies.
scan-recorder-other-rate = { $name } states a line rate of { $told_hz } Hz, but { $line_rate_hz } Hz was given and is used; check which one is right.

## Said: how far a job is

job-begun-again = The job was interrupted and is started again.
job-tried-again = The database or the storage does not answer; the job is retried automatically.
job-waits-to-begin-again = Waiting to be started again.
job-video-reading = Reading the video.
job-drift-searching = Searching for camera movement.
job-drift-background = Searching for the background in frame { $frame }.
job-board-searching = Searching for the board.
job-board-searching-frame = Searching for the board in frame { $frame }.
job-board-searching-in = Searching for the board in { $name }.
job-pose-computing = Computing the camera pose.
job-lens-fitting = Fitting the lens, and the two halves separately.
job-export-vehicles = Writing vehicles, reviews and the audit chain.
job-export-measurements = Writing the measurements.
job-export-crops = Cutting out the images of the clicks.
job-export-figures = Computing statistics, drawing figures and the report.
job-export-reading = Reading the survey.
job-export-storing = Storing the package.
job-export-packing = Packing the files.
job-heights-saving = Saving the heights that changed.
job-heights-restoring = Restoring the previous heights.
job-heights-computing = Computing the heights.
job-strips-reading = Reading the strips.
job-strips-cutting = Cutting the strips.
job-vehicles-found = Searching for vehicles. { NUMBER($count) } so far.
job-vehicles-again = Measuring the known vehicles again.
job-study-package = Writing the package.
job-study-report = Writing the report.
job-study-figures = Computing the figures.
job-passes-searching = Searching for passes.
job-demo-videos = Reading the videos.
job-demo-poses = Computing the camera poses.
job-demo-site = Simulating a site.
job-demo-saving = Saving the demonstration survey.

## The words of the standards and of the insets that the program brings, by their codes

standard-name-usa_eye_car = AASHTO (USA)
standard-name-usa_object_stopping = AASHTO (USA)
standard-name-usa_object_passing = AASHTO (USA)
standard-name-usa_eye_truck = AASHTO (USA)
standard-name-usa_headlight = AASHTO (USA)
standard-name-fitzpatrick_vehicle = Fitzpatrick et al. (proposed)
standard-name-usa_2000_eye_car = AASHTO (USA), 2000
standard-name-usa_1965_eye_car = AASHTO (USA), 1965
standard-name-usa_1920_eye_car = AASHTO (USA), 1920
standard-name-uk_eye_car = United Kingdom
standard-name-uk_eye_truck = United Kingdom
standard-name-uk_object_low = United Kingdom, low
standard-name-uk_object_high = United Kingdom, high
standard-name-italy_eye_car = Italy
standard-name-australia_eye_truck = Australia
standard-name-australia_object_stopping = Australia
standard-name-australia_eye_car = Australia
standard-name-australia_1991_eye_car = Australia, 1991
standard-name-germany_eye_car = Germany
standard-name-germany_eye_truck = Germany
standard-name-israel_eye_car = Israel
standard-name-israel_object_low = Israel, low
standard-name-own = own value
standard-class-usa_eye_car = passenger cars
standard-class-usa_object_stopping = taillights of passenger cars
standard-class-usa_eye_truck = trucks
standard-class-usa_headlight = headlights of passenger cars
standard-class-fitzpatrick_vehicle = passenger cars
standard-class-uk_eye_car = drivers
standard-class-uk_eye_truck = large heavy goods vehicles, typical
standard-class-france_eye_car = passenger cars of the study of Fambro et al. 1997
standard-class-france_object_stopping = rear lamps, lower limit, at a toll station near Paris
standard-class-australia_eye_truck = trucks
standard-class-australia_object_stopping = taillights of cars
standard-class-germany_eye_truck = trucks
standard-source-usa_eye_car = A Policy on Geometric Design of Highways and Streets (after Fitzpatrick, Lienau and Fambro, Transportation Research Record 1612, 1998)
standard-source-usa_object_stopping = A Policy on Geometric Design of Highways and Streets (after Fitzpatrick, Lienau and Fambro, Transportation Research Record 1612, 1998)
standard-source-usa_headlight = sags; Fitzpatrick, Lienau and Fambro, Transportation Research Record 1612, 1998
standard-source-fitzpatrick_vehicle = Fitzpatrick, Lienau and Fambro, Transportation Research Record 1612, 1998
standard-source-usa_1965_eye_car = AASHTO's policy of the time
standard-source-usa_1920_eye_car = first proposals (1676 mm in Fitzpatrick et al.)
standard-source-uk_eye_car = Design Manual for Roads and Bridges, TD 9/93 (now CD 109)
standard-source-uk_eye_truck = Design Manual for Roads and Bridges, TD 9/93 (now CD 109)
standard-source-uk_object_low = Design Manual for Roads and Bridges, TD 9/93 (now CD 109); Dupuis et al. print 0.25 m
standard-source-uk_object_high = Design Manual for Roads and Bridges, TD 9/93 (now CD 109): the upper end of a range
standard-source-italy_eye_car = CNR standards of 1973
standard-source-australia_eye_truck = Austroads, Guide to Road Tunnels Part 2, 4.5.2 (sags under a roof)
standard-source-australia_object_stopping = Austroads, Guide to Road Tunnels Part 2, 4.5.2 (taillight of a car)
standard-source-australia_1991_eye_car = design value of the time
standard-source-germany_eye_car = RAL (formerly RAS-L)
standard-source-germany_eye_truck = RAL (formerly RAS-L)
standard-source-israel_eye_car = national guidelines
standard-source-israel_object_low = national guidelines
standard-source-own = entered on the page
standard-cited-usa_eye_car = Dupuis et al., Sensors 2019; the percentile by the abstract of Fitzpatrick et al.
standard-cited-usa_object_stopping = Dupuis et al., Sensors 2019; the percentile by the abstract of Fitzpatrick et al.
standard-cited-usa_eye_truck = an unrecorded source
standard-cited-usa_headlight = the abstract of Fitzpatrick et al., who recommend it
standard-cited-fitzpatrick_vehicle = the abstract of Fitzpatrick et al.
standard-cited-uk_eye_car = Rogers, Highway Engineering, 2003: more than 95 % of drivers' eyes are higher
standard-cited-australia_eye_car = an unrecorded source
standard-cited-australia_1991_eye_car = the abstract of Barker and Yue, Australian Road Research 21(2), 1991
standard-cited-germany_eye_car = an unrecorded source
standard-cited-germany_eye_truck = an unrecorded source
standard-cited-israel_eye_car = an unrecorded source
standard-cited-israel_object_low = an unrecorded source
inset-note-roof = near edge of the roof; 0.85 m (u = 0.10 m) for its crown (estimate)
inset-note-roof_van = near edge of the roof (estimate)
inset-note-roof_box = a body with upright sides (estimate)
inset-note-roof_unknown = as of a car, less certain (estimate)
inset-note-driver_eye_near = driver on the side of the camera (estimate)
inset-note-driver_eye_far = driver on the side away from the camera (estimate)
inset-note-taillight = outer edge of the lamp (estimate)
inset-note-headlight = outer edge of the lamp (estimate)
inset-note-other = not known

## Ends of jobs and imports; and what things are called in errors, found again by the English (recognised.py)

jobs-cancelled = Cancelled.
jobs-gave-up = The job stopped { $attempts } times; check the input and the available memory.
jobs-broke = An error in Sightline stopped this ({ $name }); try again, and report it if it comes back.
scans-lines-not-stored = The lines of this stream were not stored, so there is no image; its vehicles remain.
scans-import-cancelled = The import was cancelled; start it again or delete the line-scan recording.
scan-simulated = Simulated, so true values are known: invented makes, one camera 0.6 px lower than the other, a rod held upright in the plane of camera 1 at 2.7 m and at 4.5 m before the first vehicle.
told-thing-camera-pose = camera pose
told-thing-line-scan = line-scan recording
told-thing-scanned-vehicle = scanned vehicle
told-thing-calibration-image = calibration image
told-thing-tyre-contacts = pair of tyre contacts
told-thing-catalogue-row = catalogue row


## App: the tour of the demonstration

tour-title = Tour of the demonstration
tour-offer = New here? The tour shows the pages of the demonstration in two minutes.
tour-take = Take the tour
tour-not-now = Not now
tour-none = There is no demonstration here. Create it on the home page, then take the tour.
tour-step = Tour, { $step } of { $of }: { $page }
tour-next = Next
tour-back = Back
tour-skip = Skip the tour
tour-end = End the tour
tour-survey = A survey measures the heights of drivers’ eyes and lamps at one site. This list shows what is done and what comes next; the pages on the left follow the order of work.
tour-recordings = A recording is a video taken from the roadside. Each shows its lighting, its start, and whether the camera moved.
tour-pose = A board of known size on the road gives the position of the camera, and the expected uncertainty of heights.
tour-measure = Choose a vehicle and click twice on one frame: where a tyre meets the road, and the eye, lamp or roof. The height appears at once, with its U95 and uncertainty budget.
tour-review = Another person accepts, fixes or rejects each height. Nobody reviews their own measurements.
tour-statistics = Only accepted heights count: their distributions, errors against known heights, and the percentiles of standards today.
tour-export = One button builds the package for a standards body: report, tables, figures and audit trail. Its receiver can verify it. You can start the tour again from the menu under your initials.

## Report: words of every report (PDF). A report is set in the language that it was asked for in.

report-kind = Measurement report
report-of-survey = { $survey }, measurement report
report-survey = Survey
report-foot = Data as of { $moment }
report-foot-head = Data as of { $moment }, audit head of the survey { $head }…
report-empty-trail = an empty audit trail
report-page = Page { $page } of { $pages }
report-between = { $low } to { $high }
report-of-all = { NUMBER($part) } of { NUMBER($all) }
report-decimal-sign = .
report-date = { $year }-{ $month }-{ $day }
report-minute = { $year }-{ $month }-{ $day } { $time }
report-moment = { $year }-{ $month }-{ $day } { $time } UTC
report-unit-m = metres
report-unit-ft = feet
report-unit-mm = millimetres
report-unit-in = inches
report-unit-cm2 = square centimetres
report-unit-in2 = square inches
report-target-driver_eye = driver’s eye
report-target-taillight = taillight, lower edge
report-target-headlight = headlight
report-target-roof = roof
report-target-other = other
report-measured-by-other = other
report-category-other = other
report-target-roof_van = roof, vans
report-target-roof_box = roof, lorries and buses
report-target-roof_unknown = roof, no class
report-target-driver_eye_near = driver’s eye, driver on the near side
report-target-driver_eye_far = driver’s eye, driver on the far side
report-many-driver_eye = drivers’ eyes
report-many-taillight = taillights’ lower edges
report-many-headlight = headlights
report-many-roof = roofs
report-light-daytime = daytime
report-light-low_light = low light
report-light-overall = overall
report-light-unknown = lighting unknown
report-measured-by-counter = speedometer
report-measured-by-radar = radar
report-measured-by-laser = laser gun
report-measured-by-gps = GPS
report-measured-by-loop = induction loop
report-measured-by-tape = tape
report-category-hatchback = hatchback
report-category-saloon = saloon
report-category-estate = estate
report-category-suv = SUV
report-category-multi_purpose = multi-purpose vehicle
report-category-pickup = pick-up
report-category-van = van
report-category-lorry = lorry
report-category-tractor_unit = tractor unit
report-category-bus = bus
report-category-recreational_vehicle = recreational vehicle
report-category-trailer = trailer or caravan
report-category-motorcycle = motorcycle
report-heading-right = to the right
report-heading-left = to the left
report-set-passenger_cars = passenger cars
report-set-light_trucks = light trucks and multi-purpose vehicles
report-set-heavy = heavy vehicles
report-divided-by-class_set = set of classes
report-divided-by-category = category
report-divided-by-site = site
report-divided-by-lighting = lighting
report-divided-by-stratum = stratum
report-divided-by-operator = operator
report-excluded-as-rejected = rejected
report-excluded-as-withdrawn = withdrawn
report-excluded-as-not_measurable = not measurable
report-excluded-as-to_review = to review
report-excluded-as-not_selected = not selected
report-excluded-as-check_target = check target
report-excluded-as-out_of_sample = outside the sample
report-filmed-since = filmed from { $day }
report-filmed-until = filmed up to { $day }
report-filmed-hours = filmed between { $begins } and { $ends }
report-filmed-nights = { $days ->
    [one] filmed in the night that begins on { $first }, { $begins } to { $ends }
    [since] filmed in the nights that begin on { $first } or later, { $begins } to { $ends }
    [until] filmed in the nights that begin on { $last } or earlier, { $begins } to { $ends }
   *[several] filmed in the nights that begin on { $first } to { $last }, { $begins } to { $ends }
}
report-lacking = { $mark } replaces characters of a script that this report’s fonts lack; the CSV files contain them.
report-check-title = How to check this report
report-median = Median
report-mean = Mean
report-sd = SD
report-standard = Standard
report-vehicles = Vehicles
report-target = Target
report-verdict = Verdict
report-figure = Figure
report-lighting = Lighting
report-camera = Camera
report-board = Board
report-pose = Pose
report-recording = Recording
report-value = Value
report-source = Source
report-bias = Bias
report-interval = 95 % interval
report-interval-total = 95 %, total

## Report: title

report-days-none = nothing yet
report-days = { $first } to { $last }
report-more-versions = and { NUMBER($n) } more (see measurements.csv)
report-verdicts-of = { NUMBER($individual) } accepted individually, { NUMBER($by_lot) } by the sample of their lot. Of the { NUMBER($of) } not reviewed individually in { $lots ->
    [one] 1 accepted lot
   *[other] { NUMBER($lots) } accepted lots
 }, { $estimate } are estimated to be wrong and { $at_most } at most (one-sided 95 %).
report-only = <strong>Only:</strong> { $selection }. The results do not include the survey’s other vehicles.
report-filmed = Filmed
report-filmed-unconfirmed = start not confirmed
report-measured = Measured
report-place = Place
report-in-this = In this report
report-in-this-of = { $measurements ->
    [one] 1 measurement
   *[other] { NUMBER($measurements) } measurements
 } of { $vehicles ->
    [one] 1 vehicle
   *[other] { NUMBER($vehicles) } vehicles
 }, { NUMBER($with_reference) } with a reference height. Accepted measurements only.
report-verdicts = Verdicts
report-state-of = Data as of
report-code = Software
report-count-recordings = recordings of the survey
report-count-vehicles = vehicles of the survey, discarded ones included
report-count-measurements = measurements of the survey, withdrawn ones included
report-count-not-visible = targets not visible, of vehicles that count
report-count-used = measurements counted in the results
report-count-left-out = measurements of the survey excluded
report-count-out-of-date = out of date of those counted (reasons: column out_of_date of the tables)
report-count-without-time = vehicles excluded because their time of filming is not known
report-count-scanned = scanned vehicles
report-count-scanned-used = accepted of them
report-span = { $day } { $first } to { $last } ({ $zone })
report-unconfirmed = { $n ->
    [one] 1 recording without a confirmed start
   *[other] { NUMBER($n) } recordings without a confirmed start
 }
report-coordinates = { $latitude }, { $longitude } (WGS84)
report-limit = limit { $speed }
report-lamps = street lamps
report-no-lamps = no street lamps

## Report: set-up, calibration, camera pose

report-setup = Set-up
report-no-photo = There is no photograph of the set-up.
report-photo-broken = The photograph “{ $caption }” cannot be read as PNG or JPEG.
report-no-recording = There are no recordings.
report-recordings = Recordings. recordings.csv contains the complete SHA-256 of each file.
report-filmed-from = Filmed from
report-picture = Frame size
report-frames = Frames
report-duration = Duration
report-model-brown = Brown’s radial and tangential model
report-model-fisheye = equidistant fisheye (Kannala and Brandt)
report-from-images = from images of a board
report-from-clip = from a clip of a board
report-from-import = imported from another tool’s file
report-lens = { $camera }, calibration { $number }
report-made = Created
report-pixels = { $width } × { $height } pixels
report-lens-model = Lens model
report-views = Views
report-views-used = { $used } of { $given } used
report-residual = Residual
report-residual-is = { $rms } px (RMS reprojection error)
report-trusted = reliable
report-not-trusted = unreliable; see the warnings
report-lens-known = Lens of { $camera }: parameters with standard uncertainties.
report-lens-unknown = Lens of { $camera }: parameters; their uncertainties are unknown.
report-board-of = { $columns } × { $rows } inner corners, squares of { $square } mm
report-board-stood = { $n ->
    [one] Pose
   *[other] Poses
 } { $poses }: reference row of corners { $height } above the road{ $u_height }{ $u_lean }.
report-board-u-height = , u = { $u }
report-board-u-lean = ; board tilt and roll, u = { $u } mrad each
report-poses = Camera poses
report-poses-caption = Camera poses. “{ $sign }”: expected U95 of a height of 1.2 m clicked to 1 px, without the inset’s part, by distance from the camera. Residual: RMS reprojection error of the board’s corners.
report-pose-at = { $sign } at { $distance }
report-above-road = { $unit } above road
report-away = { $unit } away
report-frames-of = frames { $first } to { $last }
report-calibration-of = calibration { $number }
report-no-board = none: the pose was imported
report-pose-warning = Pose { $pose }: { $words }
report-calibration = Calibration and camera pose
report-no-calibration = No measurement uses a calibration yet.
report-no-pose = No measurement uses a camera pose yet.

## Report: sample and response

report-every = Every pass is measured
report-nth = One pass in { $step } is measured, starting with number { $start }
report-share-drawn = A random share of { $share } % of the passes (seed { $seed }) is measured
report-rule = { $rule }.
report-rule-free = { $rule }, of vehicles with a headway of at least { $seconds } s.
report-set-all = all
report-set-none = no set
report-set-unknown = unknown
report-vehicle = vehicle
report-response = Sample and response
report-response-words = { $rule } Each pass in the sample is measured, not visible for a stated reason, or still open; discarded passes are not vehicles to be measured. If the rate differs between groups, the measured vehicles may not represent the traffic.
report-no-pass = No passes were found.
report-response-table = Response. Rate: measured passes (or targets) divided by those in the sample, with its exact 95 % interval.
report-classes = Classes
report-of = Of
report-passes = Passes
report-discarded = Discarded
report-outside = Outside
report-in-sample = In sample
report-not-visible = Not visible
report-open = Open
report-rate = Rate
report-outside-sample = { $counts ->
    [yes] { $n ->
        [one] 1 pass outside the sample was measured and counts in the results.
       *[other] { NUMBER($n) } passes outside the sample were measured and count in the results.
     }
   *[no] { $n ->
        [one] 1 pass outside the sample was measured and does not count in the results.
       *[other] { NUMBER($n) } passes outside the sample were measured and do not count in the results.
     }
 }

## Report: method

report-method = Method
report-method-lead = Heights are measured as proposed by Dupuis et al. (Sensors 2019, 19(7), 1611, “the paper”), with the misprints of its equations corrected (below). A checkerboard of known size on the road gives the camera pose; two clicks on one frame, where a tyre meets the road and on the target, give a height. The road frame has X along the traffic, Y across it and away from the camera, and Z up. A point { $point } of the road is imaged at the pixel
report-method-lens = where { $pose } is the pose, { $distortion } the lens distortion (Brown’s radial and tangential model, or the equidistant fisheye) and { $matrix } contains the focal lengths and the principal point. A click { $click } is converted into a direction in the road frame, from the camera centre { $centre }:
report-method-rays = The contact ray meets the road, { $road }. The target ray meets the vertical plane along the traffic at the inset { $inset } behind the contact. With one slope from each click,
report-eq-contact = contact
report-eq-target = target
report-method-height = the distance { $distance } from the camera to the contact plane and the height { $height } are
report-method-inset = The paper assumes { $inset }. A target at { $height } then reads too high by
report-method-raw = 44 mm for an eye at 1.16 m, 0.45 m inboard, 3 m from a camera 1.5 m high. Heights are therefore given twice: uncorrected (“raw”) with { $inset }, for comparison with the paper, and corrected by the inset below. Where the same two points were clicked on several frames of a pass, the inset is estimated together with the height by least squares.
report-method-u = The standard uncertainty of each height follows by linear propagation (JCGM 100:2008),
report-coverage-factor = 1.96
report-method-u-over = over both clicks, lens and pose (jointly, with their covariance), the board’s tilt, roll, height above the road, square size and bow, and the inset. One pose serves many vehicles: its error is common to all their heights.
report-assumed = Assumptions
report-assumed-plane = The road is a plane from the board to the vehicle, and the board was perpendicular to it within its stated uncertainty.
report-assumed-still = The camera did not move between the recording of the board and the measurements that use it.
report-assumed-parallel = Vehicles travel parallel to the rows of the board; their sides are vertical at the contact.
report-assumed-inset = The inset of a target is that of the list below, within its uncertainty, unless it was estimated from several frames.
report-assumed-makers = Manufacturers’ heights apply to the vehicle as it drove past, within their stated uncertainty.
report-assumed-left-out = Not included: a wrong lens model, load and suspension, crossfall changes between board and vehicle.
report-misprinted = Misprints of the paper
report-misprints = Equations of the paper as printed, and as used here.
report-equation = Equation
report-as-printed = As printed
report-as-used = As used
report-used-3 = the distortion acts after the division by depth, equation (1)
report-used-4 = the pixel is what is undistorted, equation (2)
report-used-5 = directions rotate and are not shifted, { $used }
report-used-8 = correct only where { $down } points down; corners are put into that order first
report-used-10 = a row: { $used }
report-used-13 = { $printed } is not defined; the normal of the side plane { $used } is meant
report-used-14 = { $used }, otherwise the side plane is mirrored
report-used-17 = { $used }, with the metric contact point
report-used-18 = the signed distance from the road plane, { $used }
report-insets = Current insets: distance of a target behind the plane of the contact, and its standard uncertainty.
report-inset = Inset ({ $unit })
report-from = Source

## Report: how equations are read aloud

report-aloud-pixel = p = K d(pi(R x + t)), pi(x, y, z) = (x over z, y over z)
report-aloud-ray = m = d inverse of K inverse p, w = R transposed (m x, m y, 1), C = minus R transposed t
report-aloud-slopes = s = w y over w z at the contact, q = w z over w y at the target
report-aloud-height = D = minus C z s, h = C z + (D + delta) q
report-aloud-inset = b = (C z minus h) delta over (D + delta)
report-aloud-u = u squared of h = sum over i of (dh by dx i) squared u squared of x i, U 95 = 1.96 u of h
report-aloud-4 = p = d inverse of K inverse P
report-aloud-10 = P g = minus n x d
report-aloud-10-used = minus n x transposed, d
report-aloud-13 = P c = minus C x d
report-aloud-14 = d = n z transposed p l
report-aloud-14-used = d = minus n z transposed p l
report-aloud-17 = n x p prime l over n x p prime h
report-aloud-17-used = n z transposed p l over n z transposed p prime h
report-aloud-18 = p h transposed P g over minus n x
report-aloud-18-used = n x transposed (X g minus p h)

## Report: results at a glance

report-glance = Results at a glance
report-brackets = (95 %: { $interval })
report-conclusion = Conclusion
report-filmed-on = Filmed { $moment }
report-not-covered = Not covered
report-concluded-of = { $measurements ->
    [one] 1 accepted height
   *[other] { NUMBER($measurements) } accepted heights
 } of { $vehicles ->
    [one] 1 vehicle
   *[other] { NUMBER($vehicles) } vehicles
 }, measured from roadside video.
report-concluded-rule = P{ $percent } of { $of } ({ $classes }, n = { NUMBER($n) }): { $value }{ $interval }. { $standard } uses { $limit }: { $verdict }.
report-concluded-none = P{ $percent } of { $of } ({ $classes }, n = { NUMBER($n) }) cannot be stated: { $reason }.
report-uncovered-selection = Vehicles outside the limits of this package, which covers only: { $selection }.
report-uncovered-classes = Vehicle classes: no class is known for some targets, so their figures include all vehicles.
report-uncovered-excluded = { $n ->
    [one] 1 measurement is excluded; the table of exclusions gives the reason.
   *[other] { NUMBER($n) } measurements are excluded; the table of exclusions gives the reasons.
 }
report-uncovered-not-visible = { $n ->
    [one] 1 target was not visible.
   *[other] { NUMBER($n) } targets were not visible.
 }
report-uncovered-out-of-date = { $n ->
    [one] 1 height is out of date: facts that it depends on were changed after it was computed. It is included unchanged.
   *[other] { NUMBER($n) } heights are out of date: facts that they depend on were changed after they were computed. They are included unchanged.
 }
report-uncovered-line-heights = { $n ->
    [one] 1 accepted height of a line scan: the section on line scans contains it.
   *[other] { NUMBER($n) } accepted heights of line scans: the section on line scans contains them.
 }
report-uncovered-by-lot = { $n ->
    [one] 1 accepted height was not reviewed individually: the sample of its lot was.
   *[other] { NUMBER($n) } accepted heights were not reviewed individually: the samples of their lots were.
 }
report-uncovered-others = Other roads, days and traffic: the intervals are for the traffic that passes this site.
report-readme-contents = What is in this package
report-readme-page = This package as a page: open it in a browser. It checks itself without a server.
report-readme-report = The report.
report-readme-statistics = The figures of the report as tables, unrounded.
report-readme-tables = Every vehicle, measurement and review as tables; datapackage.json describes each column.
report-readme-files = Images, figures, camera poses and calibrations, and the same tables as Parquet.
report-readme-audit = The audit chain and its signature.
report-readme-check = To check everything: sightline verify, with the key that the installation shows. To check that no file changed: sha256sum -c SHA256SUMS
report-error-none = No vehicle has a reference height, so the errors of heights cannot be stated.
report-error-short = Roof heights of { $n ->
    [one] 1 vehicle
   *[other] { NUMBER($n) } vehicles
 } with a reference height: mean absolute error { $mae }{ $mae_interval }, bias { $bias }{ $bias_interval }.
report-rules = Standards: the same percentile today. The percentile on which a standard is based, with its total 95 % interval. “Lower” or “higher” is stated if the risk of error is at most 2.5 % (JCGM 106).
report-rule-column = Rule
report-today = Today
report-difference = Difference
report-no-verdict = no verdict: { $reason }
report-alike = undecided; lower with a probability of { $percent }
report-lower = lower (risk of error { $risk })
report-higher = higher (risk of error { $risk })
report-less-than = less than { $percent }

## Report: error against reference heights

report-errors = Error against reference heights
report-errors-none = No accepted roof height has a reference height, so errors cannot be stated. Enter manufacturers’ heights in the vehicle records.
report-errors-holds = The 95 % intervals include { $holds }. Those of correlations, skewness and regression lines include sampling only.
report-errors-words = Error = measured minus reference, of roofs corrected by their inset, without rounding. All values are computed from the individual errors, never from other values.
report-errors-table = Errors with their 95 % CIs.
report-row-bias = Bias (mean error)
report-row-sd = SD of the error
report-row-r = r(error, height)
report-row-r-abs = r(|error|, height)
report-row-skewness = Skewness of the error
report-row-within = Share of errors within { $limit } cm
report-no-group = There are no accepted { $group } vehicles with a reference height.
report-reference-part = { $words } This alone causes a correlation of { $correlation } between error and height, independent of the camera (reference u = { $u }).
report-limits = Limits of agreement (Bland and Altman): { $lower } ({ $lower_interval }) and { $upper } ({ $upper_interval }).
report-as-in-the-paper = As in the paper
report-as-in-the-paper-words = For comparison with Dupuis et al. (Sensors 2019, 19(7), 1611) only. As the paper measures: inset 0, and for errors both heights rounded to whole centimetres. Percentiles are those of the measured heights, random error included; their intervals cover sampling only. No other section uses these values.
report-paper-errors = Errors as in the paper: inset 0, whole centimetres, with their 95 % CIs.
report-paper-percentiles = Percentiles as in the paper, of the heights of the { $target }; vehicles: { $raw } uncorrected, { $corrected } corrected.
report-paper = Table 1 of the paper as printed.
report-its-column = Its column
report-inconsistent = Inconsistencies
report-known-errors = Errors by target, lighting and class: measured minus known height, not rounded, with total 95 % intervals. Check targets are excluded everywhere else.
report-check-errors = Check targets: measured minus taped height, with total 95 % intervals.
report-within-u95 = Within their U95
report-known-errors-note = The intervals include errors that heights share (pose, mean inset). A model chosen by its sizes is not used as a reference.
report-check-targets = { $target }, check targets

## Report: distributions of heights

report-heights = Distributions of heights
report-heights-none = There are no accepted heights yet.
report-percentiles = True heights of the { $target }, all classes together, with total 95 % intervals; vehicles: { NUMBER($n) }.
report-holds = True heights: random measurement error is removed from the spread. Total intervals include { $holds }.
report-absent = No accepted heights: { $targets }.
report-percentile = Percentile
report-true-heights = True heights
report-corrected = Corrected
report-interval-sampling = 95 %, sampling
report-raw-inset = Uncorrected, inset 0
report-reason-of = { $percents }: { $reason }.
report-shares = Standards, and the share of { $targets } below them (true heights), with total 95 % intervals.
report-height = Height
report-below = Below (measured)
report-share = Share
report-not-corrected-why = Not corrected: { $reason }
report-percentile-of = P{ $percent } of { $of }
report-cited-by = quoted from { $who }, text itself not consulted
report-lateral = Lateral positions
report-lateral-words = Distance of the tyre contact from the camera, measured across the road: one value per vehicle, the median of its contacts. A lane is all traffic that travels one way in the frame.
report-lateral-table = Lateral positions by lane and class.
report-lateral-all = All

## Report: sight distance

report-sight = Sight distance
report-sight-words = A crest provides a sight distance S if its length per percent of grade, K, is at least S²/C. C depends only on the heights of eye and object: C = 100 (√(2 eye) + √(2 object))². The standard is { $standard } (eye { $eye }, object { $object }). The survey’s heights are percentile { $eye_percent } of the eyes and percentile { $object_percent } of the taillights’ lower edges, { $classes }{ $rule ->
    [own] , the rule of that standard according to its sources
   *[usual] , and, where the standard states no rule, that of AASHTO’s heights
 }. S is the stopping sight distance ({ $source }), rounded up as in design tables.
report-sight-missing = There is no crest for the survey’s own heights: no accepted heights of { $targets } in the class that the rule names.
report-sight-table = K of crests for the standard’s heights and for the survey’s, in { $unit } per percent.
report-design-speed = Design speed
report-stopping = Stopping distance
report-k-standard = K, standard
report-k-survey = K, survey
report-per-percent = { $unit } per %
report-sight-note = Total intervals of both percentiles of true heights (sampling, errors that heights share, random error); errors of both from the same camera pose are counted together (limits by Zou and Donner 2008). Reaction and braking follow the standard’s conventions and have no interval.

## Report: line scans

report-scans = Line scans
report-scans-words = Two line cameras at a known baseline record the same traffic (Douxchamps, Macq and Chihara). The motion of a vehicle is its speed when the front reaches camera 1 and a constant acceleration; its length is corrected for the acceleration. Time gaps run from the rear of the vehicle in front to this front, distance gaps between the same points when this front reaches camera 1. { $methods }Uncertainties include baseline, clock, misalignment, fit and boundaries.
report-scans-methods = Measured: { $methods }.
report-and = { $first } and { $last }
report-apart = { $first }; { $second }
report-scans-direct = { $n ->
    [one] 1 vehicle by registration of both strips as a whole (direct registration)
   *[other] { NUMBER($n) } vehicles by registration of both strips as a whole (direct registration)
 }
report-scans-paper = { $n ->
    [one] 1 vehicle by the paper’s block matching and linear regression
   *[other] { NUMBER($n) } vehicles by the paper’s block matching and linear regression
 }
report-rigs = Line scans and their rigs as entered; u is the standard uncertainty.
report-line-scan = Line scan
report-lines = Lines
report-baseline = Baseline
report-line-rate = Line rate
report-clock = Clock
report-divergence = Divergence
report-lane-distance = Distance to lane
report-misalignment = Misalignment
report-video-columns = columns of a video, { $lighting }
report-strips = strips, { $lighting }
report-from-traffic = from the traffic
report-with-u = { $value } (u = { $u })
report-no-vehicle = They contain no vehicles.
report-left-out-to-review = { NUMBER($n) } not reviewed yet
report-left-out-rejected = { NUMBER($n) } rejected
report-left-out-not-measurable = { NUMBER($n) } not measurable
report-none-accepted = There are no accepted vehicles of line scans.
report-accepted-count = { $n ->
    [one] 1 of { NUMBER($all) } detected vehicles accepted.
   *[other] { NUMBER($n) } of { NUMBER($all) } detected vehicles accepted.
 }
report-scans-left-out = Excluded: { $states }; scan_vehicles.csv states the reasons.
report-speed-short = Mean speed { $mean }; 85th percentile speed (V85) { $p85 } { $interval }.
report-no-interval = (no 95 % interval: { $reason })
report-quantities = Measured quantities of the accepted vehicles: percentiles with 95 % intervals.
report-quantity = Quantity
report-quantity-of-speed = speed
report-quantity-of-length = length
report-quantity-of-wheelbase = wheelbase
report-quantity-of-time_gap = time gap
report-quantity-of-distance_gap = distance gap
report-quantity-of-headway = headway
report-by-lengths = Baseline by lengths: { $reason }
report-by-wheelbases = Baseline by wheelbases: { $reason }
report-over-lengths = Measured divided by known lengths of { $n ->
    [one] 1 vehicle
   *[other] { NUMBER($n) } vehicles
 }: { $ratio } (u = { $u }). { $verdict }
report-over-wheelbases = Measured divided by known wheelbases of { $n ->
    [one] 1 vehicle
   *[other] { NUMBER($n) } vehicles
 }: { $ratio } (u = { $u }). { $verdict }
report-baseline-agrees = The ratio is within 2 u of 1, so they do not contradict the baseline.
report-sizes-none = No accepted vehicle has a known length or wheelbase, so their errors cannot be stated.
report-sizes = Errors (measured minus manufacturer’s size) in { $unit }, with 95 % CIs.
report-sizes-scatter = The intervals show the scatter of these errors only, without the baseline’s error, which all vehicles share.
report-size = Size
report-references = Differences (measured minus reference) of accepted vehicles from reference measurements, by source. Within: |E<sub>n</sub>| at most 1, that is, within the combined U95 of both (ISO 13528), with the 95 % CI of the share.
report-reference = Reference
report-all-sources = all sources
report-within = Within
report-share-within = Share within
report-references-words = About 95 % should be within. Vehicles of one rig share the error of its baseline, so several may be outside together. scan_references.csv contains all reference values.
report-scan-heights = Accepted heights above the road of scanned vehicles, from two clicks in the strip of camera 1, whose pose was calibrated with a rod; corrected by their insets. Each has its own verdict; heights waiting for review are excluded.
report-typical-u95 = Typical U95
report-waiting = Waiting
report-table-1 = Accepted vehicles in the layout of the paper’s Table I.
report-vehicle-column = Vehicle
report-speed-column = Speed
report-acceleration = Acceleration
report-length-column = Length
report-true-length = Known length
report-length-error = Length error
report-fit-error = Fit error
report-first-of = The first { NUMBER($shown) } of { NUMBER($all) }; scan_vehicles.csv contains all.

## Report: what was left out, how to check

report-left-out = Exclusions
report-nothing-left-out = No measurements were excluded.
report-left-out-of = { $n ->
    [one] 1 measurement is excluded from the results.
   *[other] { NUMBER($n) } measurements are excluded from the results.
 } The package’s CSV files list all of them.
report-left-out-first = { $n ->
    [one] 1 measurement is excluded from the results.
   *[other] { NUMBER($n) } measurements are excluded from the results.
 } The first { NUMBER($shown) } are listed here. The package’s CSV files list all of them.
report-left-out-table = Excluded measurements and reasons.
report-number = Number
report-state = State
report-reason = Reason
report-check-words = This report is part of a package of CSV and JSON files. The command below checks the package’s checksums and its audit trail, and recomputes every height from clicks, pose and camera, and every statistic from the rows. datapackage.json describes columns, units and meanings.
report-package = PACKAGE
report-trail-empty = The audit trail is empty.
report-trail = The audit trail has { $n ->
    [one] 1 event
   *[other] { NUMBER($n) } events
 } up to the last of this survey. Each contains the hash of the one before. Anyone who has kept the hash of that event can check that nothing before it was changed. That hash is the audit head of the survey, given below and at the foot of each page. The following event seals this package: it names every file by its hash. Its own hash is the audit head of the package, given where the package was built.
report-checksums = SHA-256 of the package’s files.
report-file = File

## Report: figures

report-fig-cumulative = Heights of the { $target }, cumulative
report-fig-no-height = There are no accepted heights of the { $target }.
report-fig-corrected = corrected, n = { $n }
report-fig-height-above = Height of the { $target } above the road ({ $unit })
report-fig-height = Height of the { $target } ({ $unit })
report-fig-share = Share of vehicles (%)
report-fig-share-below = { $standard }, { $share } below
report-fig-cumulative-caption = All classes together. Solid line: heights corrected by the inset. Points: percentiles of true heights with their total 95 % intervals. Shares below standards are of true heights, too.
report-fig-density = Heights of the { $target }, density
report-fig-density-axis = Density (per { $unit })
report-fig-density-caption = Corrected heights, n = { $n }; Gaussian kernel, bandwidth { $width }.
report-fig-by = Heights of the { $target } by { $grouping }
report-fig-by-caption = Corrected heights by group (number of vehicles): median (ring), 15th to 85th percentile (thick), 5th to 95th (thin); each vehicle (stroke) where they are too few.
report-fig-band = Band: 95 %, simultaneous, sampling only.
report-fig-band-pointwise = Band: 95 %, pointwise, sampling only.
report-fig-no-band = No band for fewer than { $least } vehicles.
report-fig-by-rules = Vertical lines: { $rules }.
report-fig-by-left-out = { $n } smaller groups are not shown.
report-fig-group = { $group }, n = { $n }
report-fig-no-error = No vehicle has a reference height.
report-fig-no-errors = There are no errors to draw.
report-fig-absolute-axis = Absolute error ({ $unit })
report-fig-absolute = Absolute error, cumulative
report-fig-absolute-caption = Cumulative share of vehicles by absolute error.
report-fig-relative-axis = Absolute error over reference height (%)
report-fig-relative = Relative error, cumulative
report-fig-relative-caption = Absolute error divided by the reference height.
report-fig-signed = Signed error, density
report-fig-signed-axis = Measured minus reference ({ $unit })
report-fig-signed-width = { $width } { $group }
report-fig-signed-caption = Gaussian kernel, bandwidth { $widths }.
report-fig-signed-caption-cm = Gaussian kernel, bandwidth { $widths }, at least half of the { $rounding } of rounding.
report-fig-trend = Signed error against manufacturer’s height
report-fig-regression = regression
report-fig-maker-height = Manufacturer’s height ({ $unit })
report-fig-one-mark = One mark per vehicle. { $reason }
report-fig-per = { $small } per { $height }
report-fig-seen = One mark per vehicle
report-fig-seen-some = One mark for { $shown } of { $n } vehicles
report-fig-trend-caption = { $seen }; regression with its 95 % band: slope { $slope } ({ $interval }), r = { $r }.
report-fig-trend-caption-absolute = { $seen }; regression with its 95 % band: slope { $slope } ({ $interval }), r = { $r }; absolute error: r = { $r_absolute }.
report-fig-lateral = Lateral position by lane and class
report-fig-lateral-axis = Distance from the camera across the road ({ $unit })
report-fig-lateral-caption = Tyre contact, one per vehicle, by travel direction in the frame and class (number of vehicles): median (ring), 15th to 85th percentile (thick), 5th to 95th (thin); each vehicle (stroke) where they are too few.
report-fig-crest = K of a crest against design speed
report-fig-by-standard = standard’s heights
report-fig-by-survey = survey’s heights
report-fig-design-speed = Design speed ({ $unit })
report-fig-k = K ({ $unit } per %)
report-fig-crest-caption = K = S²/C at the stopping sight distance of each speed, rounded up as in design tables. Solid: survey’s heights, with their 95 % band; dashed: standard’s.
report-fig-scanned = Scanned vehicles: { $quantity }, cumulative
report-fig-scanned-caption = n = { $n }; { $percentiles }; 95 % intervals where n allows.
report-fig-true = True heights of the { $target }, cumulative
report-fig-error-left-in = random error not removed
report-fig-true-curve = true heights
report-fig-true-caption = Solid: true heights, weighted to the fleet if one was given; the band joins the total 95 % intervals of the percentiles. Dashed: random error not removed.

## Report of a study

report-study-kind = Study report
report-study-kind-simulated = Simulated: study report
report-of-study = { $study }, study report
report-study-simulated = <strong>Simulated.</strong> Nothing was filmed: the vehicles were drawn from known fleets. No value in this report describes real roads.
report-joined = Combined
report-joined-of = { $surveys ->
    [one] 1 survey
   *[other] { NUMBER($surveys) } surveys
 } at { $sites ->
    [one] 1 site
   *[other] { NUMBER($sites) } sites
 }: { NUMBER($heights) } accepted heights of { $vehicles ->
    [one] 1 vehicle
   *[other] { NUMBER($vehicles) } vehicles
 }
report-weighted = Weighted
report-not-weighted = no: vehicles count as sampled
report-fleet-by = to the fleet’s shares by { $margins }, from its table
report-target-reason = { $target }: { $reason }.
report-study-table = Heights above the road in { $unit }: true heights, weighted to the fleet if one was given, with total 95 % intervals.
report-sites-of = { NUMBER($n) } sites
report-study-note = The intervals include sampling of vehicles and of sites, and errors that heights share (camera pose, mean inset). Random measurement error is removed from the values.
report-study-note-one-site = The intervals include sampling of vehicles and of sites, and errors that heights share (camera pose, mean inset). Random measurement error is removed from the values. With one site, they apply to that site only.
report-years-table = Years compared: later year minus first year, each weighted separately, with total 95 % intervals.
report-years = Years
report-year-figure = { $target }, { $figure }
report-figure-mean = mean
report-heights-column = Heights
report-more-higher = higher (significant)
report-more-lower = lower (significant)
report-not-told-apart = no significant difference
report-year-no-interval = no interval
report-verdict-why = { $verdict } ({ $reason })
report-makers-words = Roof heights of { NUMBER($n) } vehicles with a manufacturer’s height: mean absolute error { $mae } (95 %: { $mae_interval }), bias { $bias } (95 %: { $bias_interval }).
report-studied = Data
report-surveys = The surveys. “Included”: accepted heights that count by the survey’s sampling rule; “excluded”: those of vehicles outside the sample that do not count.
report-survey-column = Survey
report-site = Site
report-stratum = Stratum
report-year = Year
report-counts = Included
report-not = Excluded
report-true-distributions = Distributions of true heights
report-no-distribution = There are no distributions to draw.
report-true-percentiles = Percentiles of true heights of the { $target }, with total 95 % intervals. Design effect: variance under this design divided by that of a simple random sample of the same size.
report-error-left-in = Random error not removed
report-design-effect = Design effect
report-effective-n = Effective n
report-makers-errors = Error against manufacturers’ heights
report-makers-table = Error = measured minus manufacturer’s height, of roofs, not rounded, with 95 % CIs.
report-vehicle-classes = Vehicle classes
report-classes-table = Shares of classes as sampled, in %, with 95 % CIs, compared with the fleet.
report-class = Class
report-fleet = Fleet
report-further = Planning a further study
report-further-table = Sites, and vehicles per site, that would give P10 of true heights a U95 of { $goal }, if sites and vehicles vary as they do here.
report-sites = Sites
report-no-number = no number
report-study-check = The study’s package, whose SHA-256 is below, contains every value. { $command } gives the same values from packages exported from the same surveys; each package is first verified completely, down to the clicks.
report-study = STUDY
report-heads = Last hash of each survey’s audit chain when it was read.
report-last-hash = Last hash

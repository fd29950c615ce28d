# What Sightline says, in English: screens, errors, notes, report and command line. The language of the source;
# other languages are files beside this one. Keys are kebab-case, `area-what`; values carry their unit in their
# name. Marked parts: <strong>, <em>, <kbd>, <code>, <sub>, and those that a screen gives a meaning (<link>).


## Words of the domain: targets, and where to click each

target-roof = Roof
target-driver_eye = Driver's eye
target-taillight = Taillight
target-headlight = Headlight
target-other = Other
target-noun-roof = roof
target-noun-driver_eye = driver's eye
target-noun-taillight = taillight
target-noun-headlight = headlight
target-noun-other = other
target-hint-roof = the roof’s near edge where it is highest (for its crown, choose that beside the roof)
target-hint-driver_eye = the driver's eye
target-hint-taillight = the lower limit of the lit area of the taillight
target-hint-headlight = the lower limit of the headlight
target-hint-other = the point whose height you want

not-visible-hidden = hidden by another vehicle
not-visible-glare = glare
not-visible-too_dark = too dark
not-visible-outside = outside the picture
not-visible-no_driver = no driver seen
direction-right = to the right
direction-left = to the left
side-near = near side
side-far = far side
inset-driver_eye_near = Driver’s eye, near side
inset-driver_eye_far = Driver’s eye, far side

## Words of the domain: how traffic goes at a site

traffic-title = Traffic and camera
traffic-help = From these follows, by each vehicle’s direction, whether its driver sits on the side of the camera (near) or away from it (far). Without them no driver’s eye has a height.
traffic-not-said = not said yet
traffic-side = Traffic keeps
traffic-right = right
traffic-left = left
traffic-steering = Steering wheel usually
wheel-left = on the left
wheel-right = on the right
traffic-camera = The camera stands
place-title = Place and road
place-latitude = Latitude (WGS84)
place-longitude = Longitude
place-coordinates-problem = Coordinates are decimal degrees, as 49.44315 and 1.09932; south and west are negative.
place-road = Class of the road
place-roads = motorway; dual carriageway; single carriageway, rural; urban arterial; urban street; local road
place-limit = Speed limit
place-limit-is = limit { $limit }
place-limit-problem = A speed limit is a number of { $unit }.
place-lamps = Street lamps
place-lamps-present = there are
place-lamps-none = there are none
place-lamps-are = { $lamps ->
    [present] street lamps
   *[none] no street lamps
}
place-not-said = not said yet
place-zone = Time zone
place-zone-hint = Whose clocks are told there, as Europe/Paris; proposed for each recording.
camera-verge = on the verge
camera-median = in the median

asked-title = What is asked for
asked-help = A vehicle is measured when each of these is measured, or was said not to be visible.
asked-none = Choose at least one target by day and one in low light.

## Words of the domain: states of vehicles, measurements, recordings, jobs, calibrations, people

state-to_do = to do
state-partial = partly measured
state-measured = measured
state-not_visible = not visible
state-out_of_sample = Out of the sample
state-discarded = Discarded
state-to_review = to review
state-accepted = accepted
state-fixed = fixed
state-rejected = rejected
state-reopened = reopened
state-withdrawn = withdrawn
state-not_measurable = not measurable
state-done = done
state-next = next
state-waiting = waiting
state-ingesting = being read
state-ready = ready
state-failed = failed
state-queued = queued
state-running = running
state-cancelled = cancelled
state-trusted = trusted
state-not_trusted = not to be trusted
state-used = used
state-left_out = left out
state-active = active
state-inactive = switched off

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
class-set-light_trucks = Light trucks and multi-purpose
class-set-heavy = Heavy vehicles
class-set-none = no set
class-choice = Classes
discarded-no_vehicle = discarded: no vehicle
discarded-twice = discarded: found twice
discarded-cut_off = discarded: cut off by the recording
discarded-stopped = discarded: stopped or turning
discarded-other = discarded: other reason (see notes)
sample-title = Sample
sample-edit = Change the sample
sample-dialog = Which passes are measured
sample-method = Passes
sample-method-help = The rule goes by the pass’s number, so that a pass found later changes no other’s place. Passes that it leaves out end as “out of the sample”.
sample-every = every pass
sample-nth = every n-th pass
sample-share = a random share, drawn by a seed
sample-step = n
sample-step-problem = A whole number from 2 to 1000.
sample-start = First number
sample-start-problem = A whole number from 1 to n.
sample-share-percent = Share
sample-share-problem = More than 0 and at most 100 %.
sample-seed = Seed
sample-seed-problem = A whole number.
sample-free = Free-flowing: at least so long behind the vehicle before
sample-free-help = By direction, from the beginning of one pass to the next; empty: all vehicles. 5 s is usual.
sample-free-problem = Seconds, more than 0 and at most 60.
sample-quotas = Quotas
sample-quotas-help = How many vehicles you want of each kind; empty: no quota. Their progress stands beside the passes while you measure.
sample-quota-problem = A whole number from 1 on.
sample-quota = { NUMBER($measured) } of { NUMBER($wanted) }
sample-any-class = any class
sample-response = What became of the passes
sample-lighting = Lighting
sample-classes = Classes
sample-of = of
sample-passes = Passes
sample-discarded = Discarded
sample-out = Outside
sample-measured = Measured
sample-unseen = Not visible
sample-outside = { $count ->
    [one] { $count } pass was measured though it is out of the sample, and counts in the results.
   *[other] { $count } passes were measured though they are out of the sample, and count in the results.
}
sample-open = Open
sample-rate = Response
sample-rate-of = { $rate } % ({ $low } to { $high })
sample-all = all
sample-unknown = unknown
sample-vehicle = vehicle
sample-help = Response: measured over the passes in the sample, with its exact 95 % interval. Where it differs between groups, those that could be measured may differ from those that passed.
sample-rule = { $method ->
    [nth] One pass in { NUMBER($step) } is to be measured, from number { NUMBER($start) } on.
    [share] A random share of { $share } % of the passes is to be measured (seed { $seed }).
   *[every] Every pass is to be measured.
}
sample-rule-free = Only vehicles at least { $seconds } s behind the one before.
class-choice-any = all classes
class-choice-help = Sets and classes of vehicles that count; none chosen: all
class-choice-sets = Sets
class-choice-classes = Classes
checklist-all = All of them
classes-open = Classes
classes-title = Classes of vehicles
classes-help = The sets by which statistics, quotas and packages can be limited, and the legal classes that the package names. A change holds for everything measured already too: the set of a vehicle follows from its class.
classes-class = Class
classes-set = Set
classes-set-of = Set of { $category }
classes-eu = EU
classes-eu-of = EU classes of { $category }
classes-eu-problem = Classes of the EU: L, M1 to M3, N1 to N3, O1 to O4 or T.
classes-fhwa = FHWA
classes-fhwa-of = FHWA classes of { $category }
classes-fhwa-problem = Numbers from 1 to 13, such as “5 6 7” or “8-13”.

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
page-pose = Road pose
page-measure = Measure
page-checks = Checks
page-review = Review
page-repeats = Repeats
page-click-again = Click again
page-scans = Line scans
page-scan-results = Motion
page-scan = Line scan
page-export = Export
page-statistics = Statistics
page-sight-distance = Sight distance
page-studies = Studies
page-study = Study
page-catalogue = Catalogue
page-audit = Audit
page-people = People
page-jobs = Jobs
page-system = System
page-account = Account
page-guide = Guide

## Commands: buttons, menus and the list of keys

command-help = Show the keys
command-frameNext = Next frame
command-framePrevious = Previous frame
command-frameNextTen = Ten frames on
command-framePreviousTen = Ten frames back
command-secondNext = One second on
command-secondPrevious = One second back
command-frameFirst = First frame
command-frameLast = Last frame
command-frameGo = Go to a frame
command-play = Play and stop
command-loupe = Loupe, while held
command-loupeToggle = Loupe on and off
command-linesToggle = Hide and show the lines
command-brightToggle = Brighten the picture, for display only
command-cursor = Place points by keyboard: cursor on and off
command-place = Place the point at the cursor
command-zoomIn = Zoom in
command-zoomOut = Zoom out
command-zoomFit = Fit the frame
command-passNext = Next pass
command-passPrevious = Previous pass
command-target1 = Target: roof
command-target2 = Target: driver's eye
command-target3 = Target: taillight
command-target4 = Target: headlight
command-target5 = Target: other
command-notVisible = Say that the target is not visible, and why
command-newContact = New contact point
command-secondFrame = Second frame: click the same two points there
command-proposeContact = Propose the tyre's contact at the pointer
command-driverSide = Driver on the other side, near or far
command-selectNext = Select the next point
command-bestFrame = Best frame of the pass
command-whichModel = Which model fits: go to the list
command-passBegin = Mark the first frame of a pass or the board
command-passEnd = Mark the last frame of a pass or the board
command-passSplit = Split the pass before this frame
command-passJoin = Join the pass with the next one
command-passDiscard = Discard the pass
command-confirmNext = Confirm and go to the next pass
command-undo = Undo
command-redo = Redo
command-remove = Withdraw the selected measurement
command-cancel = Let go of the point, close
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
command-scanFit = Fill the window with the vehicle
command-scanTaller = Stretch the height
command-scanFlatter = Flatten the height
command-scanWheels = Click both wheels for the wheelbase
command-scanNew = Add a vehicle by its front and rear
command-scanHeight = Measure heights by contact and target
command-scanRod = Calibrate the height with a rod
command-reviewAccept = Accept
command-reviewReject = Reject
command-reviewFix = Fix
command-reviewNext = Next measurement
command-reviewPrevious = Previous measurement
command-reviewReason1 = Reason 1 of a rejection
command-reviewReason2 = Reason 2 of a rejection
command-reviewReason3 = Reason 3 of a rejection
command-reviewReason4 = Reason 4 of a rejection
command-reviewReason5 = Reason 5 of a rejection
command-reviewReason6 = Reason 6 of a rejection

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
scope-measure = Measure
scope-point = A selected point
scope-scan = Line scan
scope-review = Review

## Times, lengths, and what went wrong

time-just-now = just now
time-minutes-ago = { $minutes } min ago
time-today = today { $time }
length-problem = A length, such as { $example }.
problem-server = The server could not do this (status { $status }); try again, and tell the administrator if it stays.
problem-refused = The server refused this (status { $status }).
problem-stopped = This was stopped.
problem-page = Something went wrong in this page; reload it, and tell the administrator if it happens again.
problem-offline = The server cannot be reached.
problem-unreachable = The server could not be reached, so this was not done; check the connection and try again.
keys-reserved = The browser keeps { $chord } for itself; choose another key.

## Addresses of things that are not there

address-elsewhere = { $what ->
    [vehicle] The vehicle in this address is not in this survey, or was deleted.
    [measurement] The measurement in this address is not in this survey, or was withdrawn.
    [recording] The recording in this address is not in this survey, or cannot be shown.
    [camera] The camera in this address is not in this survey; another is shown.
   *[scan] The line-scan recording in this address is not in this survey.
}

## Components: progress, undo

loading = Loading { $what }…
job-queued = Waiting for its turn
job-working = Working
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

jobs-only-failed-again = This job is { $state }; only one that failed or was stopped is done again.
jobs-again-on-its-page = Work of this kind ({ $kind }) begins again on the page of its recording, where its files are looked at too.

## System: the page of administrators

system-lead = How this installation is doing just now. Prometheus reads the same on a port of its own.
system-loading = the state of the system
system-program = Program and machine
system-version = Version
system-database = Database
system-database-of = { $kind ->
    [sqlite] SQLite
   *[other] PostgreSQL
  }, { $count ->
    [one] 1 connection in use
   *[other] { $count } connections in use
  }
system-media = Videos and pictures
system-free = Free on the disk
system-memory = Memory of the server
system-unknown = not told by this machine
system-decoder = Decoder of stills
system-decoder-none = not needed just now
system-decoder-runs = process { $process }
system-waiting = Waiting for their turn
system-waiting-of = { $reading } to read, { $writing } to write
system-jobs = Jobs

## Jobs: the page

own-name-title = What is your name?
own-name-why = It stands beside everything that you measure, judge and change.
own-name = Your name
jobs-lead = Long work of the server: what waits, what is under way, what came of it.
jobs-loading = the jobs
jobs-show = Show
jobs-all = All
jobs-none-title = No jobs here
jobs-none = Reading videos, finding passes, poses, calibrations and packages appear here.
jobs-kind = { $kind ->
    [ingest] Reading a video
    [passes] Finding passes
    [proposals] Proposing points
    [pose] Road pose
    [calibrate] Calibration
    [drift] Looking for camera drift
    [export] Package
    [scan_read] Reading strips
    [scan_find] Finding vehicles in strips
    [scan_tidy] Tidying up after strips
    [demonstration] Demonstration survey
    [demonstration_study] Demonstration study (simulated)
    [study] Study
   *[other] Other work
}
jobs-column-what = What
jobs-column-for = For
jobs-column-state = State
jobs-column-said = What it says
jobs-column-begun = Begun
jobs-again = Once more
jobs-begun-again = It begins once more.

## App: titles, the bar above, the rail, addresses that lead nowhere

app-name = Sightline
app-title = { $page } – Sightline
app-title-in-survey = { $page } – { $survey } – Sightline
app-not-found = Not found
app-skip = Skip to the page
app-skip-picture = Skip to the picture
app-to-surveys = Go to the surveys
app-nothing-here-title = There is nothing at this address
app-nothing-here = The link may be old, or the survey may have been removed.
app-not-loaded = This page could not be loaded, perhaps because a newer version was installed; reload it.
app-loading-page = { $page ->
    [sign-in] sign in
    [surveys] surveys
    [survey] overview
    [planning] plan the site
    [camera] camera
    [recordings] recordings
    [pose] road pose
    [measure] measure
    [checks] checks
    [review] review
    [repeats] repeats
    [click-again] click again
    [scans] line scans
    [scan-results] motion
    [scan] line scan
    [export] export
    [statistics] statistics
    [sight-distance] sight distance
    [studies] studies
    [study] study
    [catalogue] catalogue
    [audit] audit
    [people] people
    [jobs] jobs
    [system] the state of the system
    [guide] guide
   *[account] account
}
app-where = Where you are
app-survey = Survey
app-other-step = { $page }: go to another step
app-keys = Keys
app-work = Order of work
app-audit = Audit trail
save-waiting = { $count } not yet saved
save-pending = saving…
save-failed = last change not saved
save-done = saved { $time }
menu-person = { $person }: account and settings
menu-role = { $role } · Sightline { $version }
menu-theme = Theme
menu-theme-system = System
menu-theme-light = Light
menu-theme-dark = Dark
menu-lengths = Lengths
menu-lengths-metres = Metres
menu-lengths-feet = Feet
menu-sign-out = Sign out

## App: while the server cannot be reached

offline-kept = { $count ->
    [one] { $count } change is kept in this browser and will be saved when it is back.
   *[other] { $count } changes are kept in this browser and will be saved when it is back.
}
offline-changes = { $count ->
    [one] { $count } change will be saved when it is back; keep this page open.
   *[other] { $count } changes will be saved when it is back; keep this page open.
}
offline-next = Next try in { $seconds } s.
offline-now = Trying again…
offline-try = Try now

## App: what was refused, or changed by somebody else meanwhile

unsaved-refused = <link>{ $what }</link>: { $problem } Yours: { $mine }.
unsaved-conflict = <link>{ $what }</link>: { $problem } Yours: { $mine }. Theirs: { $theirs }.
unsaved-take = Take theirs
unsaved-keep = Keep mine
unsaved-again = Try again
unsaved-drop = Let it go
unsaved-otherwise = The server stored something else than was asked for; look at it again.

## App: the list of keys

keys-how = To change a key, click on it, then press the new one; it is kept in this browser.
keys-usual = Back to the usual keys
keys-clash = { $chord } now means both “{ $one }” and “{ $other }”; the first one wins.
keys-elsewhere = On other screens
keys-wheel = Wheel: zoom at the pointer. Drag with the middle button, or with Space held: move the picture.
keys-of = { $command }: { $keys }. Change
keys-change = Change the key
keys-press = press a key…

## Boards: the kind of a board and its markers

board-kind = Kind of board
board-checkerboard = Checkerboard
board-charuco = ChArUco
board-dictionary = Dictionary
board-marker = Marker’s side
board-marker-problem = Give the side of the black marker, for example { $example }.
board-marker-too-large = A marker is smaller than its square.

## Did the camera move

drift-title = Did the camera move?
drift-stopped = The check stopped.
drift-under-way = Whether the camera moved since its road pose is being looked at.
drift-not-yet = Whether the camera moved since its road pose has not been looked at.
drift-holds = Still good, says { $person }: { $reason }
drift-over-time = Over the recording's time
drift-again = Look again
drift-take-back = Take the decision back
drift-reason = The pose is still good, because
drift-decide = Decide: still good
drift-look = frame { $frame }: { $moved_px } px, { $change }
drift-figure = { $untold ->
    [0] { $count } frames against the road pose's; worst { $worst } of height for a target { $target } high at { $distance }. The band is what could not be told from standing still.
   *[other] { $count } frames against the road pose's, { $untold } told nothing; worst { $worst } of height for a target { $target } high at { $distance }. The band is what could not be told from standing still.
}

## Figures: their downloads and marks

figure-as-svg = { $figure } as SVG
figure-as-csv = { $figure } as CSV
figure-standard = { $standards } { $height } { $unit }

## Vehicles: budget, history, catalogue, passes

budget-title = Where the uncertainty comes from
budget-note = standard uncertainty
budget-together = together
revisions-computed-again = computed again; clicked by
revisions-title = History
revisions-who = { $person }, { $time }
revisions-review = { $person } – { $reason }
catalogue-list = { $field } in the catalogue
catalogue-other-years = The catalogue has { $model } of { $years } only; is the year right?
passes-find = Find the passes
passes-find-title = Looks through the video for vehicles; passes that are there or were discarded stay as they are
passes-failed = The search failed; try it again.
passes-cancelled = The search for passes in { $recording } was cancelled.
passes-found = { $recording }: { $message }
passes-over = { $recording }: the search is over.
passes-all = All
passes-to-do = To do
passes-rejected = Rejected
passes-measured = Measured
passes-left-out = out of the sample
passes-by-number = by number
passes-by-time = by time
passes-by-state = by state

## The picture: frame, loupe, timeline, transport

viewer-frame = frame { $frame }
viewer-frame-label = Frame { $frame }
viewer-frame-at = frame { $frame }, { $time }
viewer-stand-in = thumbnail of frame { $thumbnail }; frame { $frame } is coming
viewer-what = frame
viewer-layers = Axes and points over the picture
viewer-bright = display only: brightened
viewer-pointer = x { $x } y { $y }
viewer-wrong-frame = The server sent frame { $served } for frame { $frame }, so it is not shown; ingest the recording again.
viewer-slid = Nothing was placed: the pointer moved on while the button was down. Space and a drag move the picture.
viewer-changed = Nothing was placed: another picture came while the button was down. Click again.
viewer-first-corner = first
timeline-label = Position in the recording
timeline-decoded = Decoded on the server
transport-play = Play
transport-stop = Stop
transport-frame = frame
transport-of = of { $last_frame }
transport-vfr-title = The frame rate of this recording varies; times come from each frame's own stamp.
blind-elsewhere = Another frame than the one to click on; that is { $frame }.
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

camera-lead = A body and lens at one setting of zoom and focus. Calibrating it tells how the lens bends the picture, and how well that is known.
camera-another = Another camera
camera-loading-all = cameras
camera-loading = the camera
camera-none-title = No camera yet
camera-none = Name the camera that filmed this site. Then drop in some fifteen pictures of a checkerboard, taken with it at the same zoom and focus, or a file with its calibration from another tool.
camera-add-first = Add the camera
camera-list = Cameras
camera-take-open = From another survey
camera-take-title = A camera of another survey
camera-take = Take it over
camera-take-lead = Its current calibration comes along, with the pictures that it was made of. From then on each survey has its own: a new calibration in one changes no height in the other.
camera-take-survey = Survey
camera-take-camera = Camera
camera-take-none = No camera of this survey has a calibration yet.
camera-take-no-other = There is no other survey yet.
camera-taken-from = taken over from { $place }
camera-add = Add a camera
camera-name = Camera { $number }
camera-edit = Change
camera-edit-title = { $camera }
camera-words-none = Lens, zoom and focus are not said yet.
camera-zoomed = zoom { $zoom }
camera-focused = focus { $focus }
camera-lens-words = Lens
camera-lens-words-hint = Maker and range, as engraved on it: 24-70 mm f/2.8.
camera-zoom = Zoom
camera-zoom-hint = As it was set, and whether it is taped: 28 mm, taped.
camera-focus = Focus
camera-focus-hint = By hand, and at what distance. Autofocus changes the lens with every picture.
camera-name-problem = A camera needs a name.
camera-notes-hint = Body, picture size, steadying switched off: what else must stay the same for the calibration to hold.

## Camera: calibrating

camera-calibrate = Calibrate
camera-calibrate-again = Calibrate again
camera-where-boards = Where the boards are
camera-from-pictures = From pictures
camera-from-recording = From a recording
camera-choose-pictures = Choose pictures of the checkerboard
camera-drop-pictures = Drop pictures of the checkerboard here, or click to choose
camera-drop-hint = Same camera, same zoom and focus. Tilt the board, bring it into every corner, keep it sharp.
camera-found-in = { $count ->
    [one] The board was found in <strong>{ $found }</strong> of { $count } image.
   *[other] The board was found in <strong>{ $found }</strong> of { $count } images.
}
camera-too-few = At least three are needed; twelve to twenty from different sides give a good calibration.
camera-more-better = That will do; twelve to twenty, with the board tilted and in every corner of the picture, do better.
camera-other-board = The images were searched for another board; look again for { $columns } × { $rows } inner corners.
camera-other-board-markers = The images were searched for another board; look again for { $columns } × { $rows } inner corners and markers of { $dictionary }.
camera-look-again = Look again
camera-to-go = { $count ->
    [one] { $count } image to go
   *[other] { $count } images to go
}
camera-import = Import a calibration file
camera-import-title = OpenCV YAML or JSON, ROS camera_info, Kalibr, mrcal
camera-imported = { $file } was read.
camera-failed = The calibration failed; try again.
camera-recording-frames = { $count ->
    [one] { $recording } ({ $count } frame)
   *[other] { $recording } ({ $count } frames)
}
camera-every = Every n-th frame
camera-first-frame = First frame
camera-last-frame = Last frame
camera-no-recording = No recording is ready; <link>bring in the clip</link> in which the board is moved about.
camera-every-problem = Take every n-th frame, with n a whole number from 1.
camera-frames-problem = Give the first and last frame as whole numbers.
camera-frames-order = The last frame lies before the first.
camera-frames-end = The recording ends with frame { $last_frame }.
camera-lens = Lens
camera-lens-brown = Ordinary lens
camera-lens-fisheye = Fisheye
camera-lens-brown-hint = Pinhole with Brown distortion: up to about 100° of view.
camera-lens-fisheye-hint = Equidistant with four terms: for lenses that see more than about 100°.
camera-board = Board
camera-board-flat = Flat board
camera-board-bent = May be bent
camera-board-flat-hint = On a stiff plate. The result says how flat it was.
camera-board-bent-hint = Paper on a wall or thin sheet: its shape is solved for too. Needs six views, better 15.
camera-three-images = Three images with the board are the least; the button wakes up then.
camera-corners-found = { $count ->
    [one] { $count } corner found in { $image }
   *[other] { $count } corners found in { $image }
}
camera-remove = Remove { $image }
camera-found-some = { $found } of { $all } found
camera-found-all = { $columns } × { $rows } found

## Camera: the board

camera-inner-corners = Count the <strong>inner corners</strong>: the points where four squares meet. A board of 10 by 7 squares has 9 by 6.
camera-charuco-corners = Makers of ChArUco boards often state the squares: one less each way. Part of the board in a picture is enough.
camera-columns = Columns
camera-rows = Rows
camera-square = Side of one square
camera-square-hint = Measure across ten squares with a ruler and divide by ten: printers rarely keep the size.
camera-square-problem = { $unit ->
    [ft] Give the side of one square in inches, for example { $example }.
   *[m] Give the side of one square in millimetres, for example { $example }.
}
camera-count-problem = { $what ->
    [rows] Give the number of rows as a whole number.
   *[columns] Give the number of columns as a whole number.
}
camera-count-range = { $what ->
    [rows] Between 3 and 50 rows can be found; count the inner corners again.
   *[columns] Between 3 and 50 columns can be found; count the inner corners again.
}
camera-drawing = { $kind ->
    [charuco] A ChArUco board, markers in its white squares, with { $columns } inner corners across and { $rows } down: the points where four squares meet. The outer edge does not count.
   *[checkerboard] A board with { $columns } inner corners across and { $rows } down: the points where four squares meet. The outer edge does not count.
}
camera-drawing-columns = { $count ->
    [one] { $count } column
   *[other] { $count } columns
}
camera-drawing-rows = { $count ->
    [one] { $count } row
   *[other] { $count } rows
}
camera-drawing-square = square { $side }

## Camera: a calibration

camera-calibrations = Calibrations
camera-loading-calibration = the calibration
camera-trusted = This calibration can be trusted
camera-not-trusted = This calibration is not to be trusted
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
camera-use = Use this one
camera-residual = residual (rms)
camera-not-told = not told
camera-download = camera.json
camera-views-used = { $count ->
    [one] { $used } of { $count } view used
   *[other] { $used } of { $count } views used
}
camera-picture = picture
camera-across = { $model ->
    [fisheye] fisheye, about { $angle }° across
   *[brown] ordinary lens, about { $angle }° across
}
camera-u = u = { $u }
camera-u-note = u is the standard uncertainty (k = 1).
camera-fx = focal length, across
camera-fy = focal length, down
camera-cx = optical centre, across
camera-cy = optical centre, down
camera-distortion = distortion { $name }
camera-coverage-unknown = Which parts of the picture the boards covered is not known for this calibration.
camera-coverage = Where corners were seen: { $percent } % of the picture.
camera-coverage-label = Coverage of the picture: { $empty } of { $all } parts hold no corner
camera-coverage-cell = { $count ->
    [one] { $count } corner
   *[other] { $count } corners
}
camera-covered = Every part of the picture was covered well enough.
camera-reshoot = What to shoot again
camera-residuals = Residual of each view
camera-left-out = { $count ->
    [one] { $count } view left out
   *[other] { $count } views left out
}
camera-no-reason = no reason told
camera-residuals-label = Residuals of { $file }, the longest { $longest_px } pixels
camera-worst-view = Worst view.
camera-residuals-drawn = { $file }: residuals drawn { $times } times as long; the longest is { $longest_px } px.
camera-history-made = made
camera-history-by = by
camera-history-from = from
camera-history-verdict = verdict
camera-history-summary = summary
camera-history-show = show
camera-history-shown = shown
camera-show = Show
camera-source-images = images
camera-source-clip = a recording
camera-source-import = a file

## Camera: the checks of a calibration

camera-checks = Checks
camera-halves = Two halves, calibrated apart
camera-halves-not-done = Not done. { $reason }
camera-halves-nothing = The picture shows too little of such a scene to compare a height.
camera-halves-differ = Two halves of the pictures, calibrated apart, differ by { $differences } in a height.
camera-difference-at = { $difference } at { $distance }
camera-held-out = Residual of pictures that did not help to find the lens: { $held_out }; of those that did: { $fit }.
camera-under = under { $length }
camera-vehicle-at = vehicle at
camera-heights-differ = heights differ by
camera-expected = expected (k = 1)
camera-not-in-picture = not in the picture
camera-halves-note = An eye at { $eye }, camera level at { $camera }, board at { $board }, the same clicks through either half. Expected is what the noise of the corners alone would make.
camera-flatness = Flatness of the board
camera-board-solved = Solved for: the board bends by { $bow }; taken as flat the residual is { $flat }, with its shape solved for { $bent }.
camera-board-taken-flat = Taken as flat. From the pictures it bends by { $bow }; taken as flat the residual is { $flat }, with its shape solved for { $bent }.

## Road pose: the page

pose-loading = the road pose
pose-no-recording-title = No recording with the board yet
pose-no-recording = Add the video in which the checkerboard stands on the road; the road pose is found from it.
pose-add-recordings = Add recordings
pose-mark-first = Mark the first frame of the board
pose-mark-last = Mark the last frame of the board
pose-side = Board and result
pose-board-span = Board: frames { $first_frame } to { $last_frame }
pose-go-again = This recording has its road pose. To find it again, go to a frame in which the board stands still.
pose-go = Go to a frame in which the board stands still.
pose-looking = Looking for the board…
pose-found-part = Part found
pose-found = { $columns } × { $rows } found
pose-chosen = This pose now holds for the recording; heights clicked from now on use it.

## Road pose: the questions

pose-lens = Recording and lens
pose-calibration-none = none yet
pose-calibration = { $state ->
    [current] { $camera }, { $calibration }, current
    [current_not_trusted] { $camera }, { $calibration }, current, not to be trusted
    [not_trusted] { $camera }, { $calibration }, not to be trusted
   *[other] { $camera }, { $calibration }
}
pose-board = The board
pose-columns = Inner corners across
pose-rows = and down
pose-square = Square
pose-corners-hint = Inner corners are where four squares meet: a board of 10 by 7 squares has 9 by 6.
pose-charuco-hint = A road pose needs the whole board in sight.
pose-still = Frames in which it stands still
pose-begins = Begins here
pose-begins-title = The first frame
pose-ends = Ends here
pose-ends-title = The last frame
pose-span-offer = The board stands still from frame { $first_frame } to { $last_frame }.
pose-span-take = Take these frames
pose-not-marked = not marked yet
pose-end-not-marked = from { $first_frame }, end not marked
pose-marked = { $count ->
    [one] { $first_frame } to { $last_frame }, { $count } frame
   *[other] { $first_frame } to { $last_frame }, { $count } frames
}
pose-height = How high it stands
pose-reference = Reference row
pose-reference-bottom = lowest row of corners
pose-reference-top = uppermost row
pose-reference-height = { $reference ->
    [top] From the road up to the uppermost row of inner corners
   *[bottom] From the road up to the lowest row of inner corners
}
pose-drawing = { $reference ->
    [top] The tape runs from the road up to the uppermost row of inner corners.
   *[bottom] The tape runs from the road up to the lowest row of inner corners.
}
pose-drawing-tape = tape
pose-drawing-road = road
pose-sure = How sure these are
pose-u-tape = u of the tape
pose-u-lean = u of the lean
pose-u-square = u of a square
pose-u-bow = u of the bow
pose-u-hint = Standard uncertainties, all estimates until you measure them: 3 mm is a steel tape read with care on asphalt; 0.3° is a board set with a good spirit level, towards the camera and sideways alike; a print is true to 0.1 % of a square; the middle of a stiff board is out of plane by 0.5 mm. Each goes into every height's budget under its own name.
pose-find = Find the road pose
pose-find-again = Find the road pose again
pose-stopped = Stopped; nothing was changed.
pose-look-only = You may look; an operator finds the pose.
pose-problem-calibration = Calibrate the camera first; without its lens there is no pose.
pose-problem-board = A board has at least 2 by 2 inner corners.
pose-problem-square = Measure one square over several and enter its side.
pose-problem-height = Measure it with a tape; every height rests on it.
pose-problem-u = Each is a figure of zero or more.
pose-problem-span = Mark the frames in which the board stands still.

## Road pose: the result

pose-result = The recording's road pose
pose-download = pose.json
pose-result-earlier = An earlier road pose
pose-use = Use this pose for the recording
pose-measure = Measure with it
pose-expected = Expected uncertainty of a height
pose-expected-distance = at a distance of
pose-expected-good = a height is good to (95 %)
pose-expected-U95 = ± { $U95 }
pose-expected-reason = At { $distance }: { $reason }
pose-facts = Frames { $first_frame } to { $last_frame }; corners fit to { $fit }; board at { $distance }.
pose-other-recording = another recording
pose-poses = { $count ->
    [one] { $count } pose in this survey
   *[other] { $count } poses in this survey
}
pose-made = { $time }, frames { $first_frame } to { $last_frame }
pose-use-short = Use

## Recordings

recordings-lead = Every frame is numbered by the server as it decodes the file, so frame n is the same picture for everybody.
recordings-loading = recordings
recordings-choose = Choose videos to upload
recordings-drop = Drop videos here, or click to choose
recordings-drop-hint = A broken connection does no harm: the upload goes on where it stopped, also after this page was closed.
recordings-uploads = Uploads
recordings-none-title = No recordings yet
recordings-none = Drop the day's video above: MP4, MOV, AVI, MKV and what else a camera writes. The clip in which the checkerboard stands on the road counts too: the road pose is found in it.
recordings-none-look = An operator can upload the day's video here.
recordings-delete-title = Delete { $recording }?
recordings-delete-body = The video, its frame table and its road poses go; a recording with measurements cannot be deleted.
recordings-delete = Delete the recording
recordings-delete-one = Delete { $recording }
recordings-deleted = { $recording } was deleted.
recordings-vfr-title = Variable frame rate: times come from each frame's own time stamp
recordings-find-road = Find the road
recordings-measure = Measure
recordings-read-again = Read it again
recordings-unreadable = This recording could not be read.
recordings-no-picture = no picture
recordings-no-picture-yet = no picture yet
recordings-rename = Rename
recordings-rename-one = Rename { $recording }
recordings-name = Name of the recording
recordings-frames = { $count ->
    [one] { $count } frame
   *[other] { $count } frames
}
recordings-rate = { $rate } per second
recordings-rate-average = { $rate } per second on average
recordings-codec = { $codec } in { $container }
recordings-sha256 = SHA-256 { $sha256 }
recordings-no-camera = No camera yet: <link>calibrate one</link>.
recordings-camera = Camera
recordings-camera-unsaid = not said yet
recordings-camera-uncalibrated = { $camera } (not calibrated)
recordings-lighting = Lighting
recordings-lighting-proposed = Lighting <muted>(proposed)</muted>
recordings-lighting-of = Lighting of { $recording }
recordings-lighting-of-proposed = Lighting of { $recording }, proposed by the machine
recordings-lighting-guess = { $lighting } ?

filmed-start = Filmed from { $time } ({ $zone })
filmed-at = filmed { $time }
filmed-proposed = Start not confirmed; proposed from the file: { $time } ({ $zone })
filmed-unknown = Start not known: the file states none.
filmed-edit = Change
filmed-edit-of = Change when and in what weather { $recording } was filmed
filmed-confirm = Confirm the start
filmed-confirm-of = Confirm the start of { $recording }
filmed-confirm-action = Confirm
filmed-title = When { $recording } was filmed
filmed-started = First frame, by the clocks of the place
filmed-unsay = Not known
filmed-from-file = Proposed from the file: { $time }. Cameras’ clocks are often off by minutes, or by the hour of summer time: compare with a watch that was filmed, or with your notes.
filmed-from-file-none = The file states no time: take it from a watch that was filmed, or from your notes.
filmed-zone = Time zone
filmed-which = This hour came twice
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
filmed-not-said = not said

## Uploads

upload-state = { $state ->
    [waiting] { $file }: about to start
    [paused] { $file }: paused
    [retrying] { $file }: connection broken, trying again
    [failed] { $file }: stopped
    [read] { $file }: here, being read
    [kept] { $file }: here
   *[sending] { $file }: sending
}
upload-resumed = { $file }: sending, resumed at { $arrived }
upload-amount = { $arrived } of { $size }
upload-rate = { $arrived } of { $size } · { $speed }/s · { $time } left
upload-pause = Pause
upload-resume = Resume
upload-cancel = Cancel the upload of { $file }
upload-empty = { $file } is empty; choose the file again after checking the copy.
upload-not-loaded = The page could not be loaded fully; reload it and choose the file again.
upload-broken = The connection broke while { $file } was sent; what arrived is kept, so press “Resume” when the connection is back.
upload-unfinished = { $file }: not finished; drop the same file again and it goes on from here
upload-discard-title = Throw away the part that arrived?
upload-discard-body = { $arrived } of { $file } are on the server.
upload-discard = Throw it away
upload-discard-one = Throw away the unfinished upload of { $file }

## Words that many pages need

interval = { $low } to { $high }
person-system = the system
person-unknown = unknown
menu-language = Language
stage-frame = Frame
stage-frames = Frames
stage-timeline = Timeline
stage-fit = Fit
stage-lines = Lines
stage-bright = Bright
stage-loupe = Loupe
vfr = VFR
field-name = Name
field-recording = Recording
field-calibration = Calibration
in-use = in use
field-notes = Notes
action-add = Add
action-cancel = Cancel
action-close = Close
action-dismiss = Dismiss
action-keep = Keep it
action-save = Save
action-try-again = Try again
action-clear-filter = Clear the filter
action-print = Print
file-csv = CSV
figure-share-of-vehicles = share of vehicles (%)
with-unit = { $name } ({ $unit })
percent = { $percent } %
with-u = { $value } (u = { $u })
value-px = { $value } px
value-s = { $value } s
file-svg = SVG
unit-px = px
unit-hz = Hz
unit-ppm = ppm
unit-mrad = mrad

## Checks: the page

adjust-lead = What vehicles of known wheelbase and height say of the road pose. Nothing changes until somebody puts the adjusted pose in force; that computes the heights again, and both are taken back together.
adjust-tab = Adjustment
adjust-loading = the adjustment
adjust-no-pose = No recording has a road pose yet.
adjust-pose = Road pose { $pose }: { $recordings }
adjust-seen = Both tyres and a known wheelbase: { $tyres } vehicles. A measured roof and a known height: { $roofs }.
adjust-u-wheelbase = u of a wheelbase without one ({ $unit })
adjust-u-wheelbase-common = u shared by all wheelbases ({ $unit })
adjust-u-roof-common = u shared by all roofs ({ $unit })
adjust-u-problem = A length from 0 to 1 m, such as { $example }.
adjust-used = { $used } of { $passes } observations used.
adjust-global-holds = The global test holds: chi-square { $chi2 } with { $freedom } degrees of freedom stays below { $limit }.
adjust-global-fails = The global test fails: chi-square { $chi2 } with { $freedom } degrees of freedom is above { $limit }, so the stated uncertainties do not hold together.
adjust-largest = The largest change of a stored height is { $largest }.
adjust-adjusted = This pose was adjusted by the traffic; the one before it is number { $pose }.
adjust-put = Put in force
adjust-put-done = The adjusted pose is in force.
adjust-take-back = Take back
adjust-taken-back = The pose before is in force again.
adjust-moved-title = What moved
adjust-what = what
adjust-value = by
adjust-by-u = by its u
adjust-by-u-help = the change divided by the standard uncertainty before
adjust-u-before = u before
adjust-u-after = u after
adjust-camera_height_m = camera’s height above the road
adjust-road_lean_rad = road’s turn about its length (lean)
adjust-road_roll_rad = road’s turn about the way across (roll)
adjust-board_lean_rad = board’s lean
adjust-board_roll_rad = board’s roll
adjust-board_height_m = height of the board’s row
adjust-square_m = square of the board
adjust-bow_along_rows_m = board’s bow along its rows
adjust-bow_down_columns_m = board’s bow down its columns
adjust-wheelbase_common_m = error that all wheelbases share
adjust-roof_common_m = error that all roofs share
adjust-left-title = Not used
adjust-left-none = Everything that was seen is used.
adjust-of-tyres = tyres
adjust-of-roof = roof
adjust-models-title = Without one model
adjust-models-note = The camera’s height if the vehicles of one model are left out, against all: a model that carries the result alone would show here.
adjust-model = model
adjust-vehicles = vehicles
adjust-camera = camera’s height
adjust-heights-title = What each height would become
adjust-now = now
adjust-then = adjusted
computing-lead = Heights follow from the road pose, the inset, the driver’s side and the program. When one of these changes, stored heights stay as they are until somebody computes them again here: as new revisions, old beside new, and undone as a whole.
computing-loading = what is out of date
computing-fine = Every height follows from what holds now.
computing-stale = { $count ->
    [one] One height follows from facts that no longer hold: { $causes }.
   *[other] { $count } heights follow from facts that no longer hold: { $causes }.
}
computing-waiting = { $count ->
    [one] One of them has no height yet and will have one.
   *[other] { $count } of them have no height yet and will have one.
}
computing-other-program = { $count ->
    [one] One height was computed by another version of the program. It may come out alike; computing again tells.
   *[other] { $count } heights were computed by another version of the program. They may come out alike; computing again tells.
}
computing-cause-pose = { $count } by another road pose
computing-cause-inset = { $count } by another inset
computing-cause-side = { $count } by another side of the driver
computing-cause-program = { $count } by another version of the program
computing-start = Compute again
computing-look = See and compute again
computing-nothing-changed = No height came out as another one, so nothing was stored.
computing-done = { $count ->
    [one] One height computed again.
   *[other] { $count } heights computed again.
}
computing-runs = Computed before
computing-runs-none = Nothing was computed again in this survey.
computing-when = when
computing-who = by
computing-kind = why
computing-kind-asked = asked for
computing-kind-sides = the driver’s side was told
computing-kind-adjustment = an adjusted pose was put in force
computing-kind-undo = undo
computing-heights = heights
computing-to-review = to review
computing-largest = largest change
computing-undone = undone
computing-show = Show
computing-shown = shown
computing-old-new = Old beside new
computing-summary = { $count ->
    [one] One height by { $causes }; mean change { $mean }, largest { $largest }.
   *[other] { $count } heights: { $causes }; mean change { $mean }, largest { $largest }.
}
computing-summary-undo = { $count ->
    [one] One height was put back as it was before.
   *[other] { $count } heights were put back as they were before.
}
computing-kept = { $count ->
    [one] One was changed since and stays as it is.
   *[other] { $count } were changed since and stay as they are.
}
computing-sent = { $count ->
    [0] None moved by more than the standard uncertainty it had, so every verdict still holds.
    [one] One moved by more than the standard uncertainty it had and goes to review; the other verdicts still hold.
   *[other] { $count } moved by more than the standard uncertainty they had and go to review; the other verdicts still hold.
}
computing-undo = Undo all
computing-undo-text = Every height of this computing becomes what it was before, as a new revision. What somebody changed since stays as it is.
computing-figure = Change of each height
computing-figure-says = The change of { $count } heights against their distance across the road, in { $small }.
computing-figure-x = contact across the road ({ $unit })
computing-figure-y = new − old ({ $small })
computing-figure-note = Filled: moved by more than the standard uncertainty it had. A change that grows with the distance comes from the road pose; one alike for a target, from its inset.
computing-figure-none = No height stands both before and after.
computing-vehicle = vehicle
computing-target = target
computing-before = old
computing-after = new
computing-change = change
computing-by-u = by its u
computing-by-u-help = the change divided by the standard uncertainty that the height had
computing-review-yes = to review
computing-repeat = repeat
computing-listed = The { $count } that moved most by their u are listed; the package has all of them.
computing-table = Old and new heights
computing-job = the job
checks-again = Compute again
checks-lead = What the vehicles themselves say of the insets and of the road’s axes.
checks-loading = the checks
checks-which = Check
checks-insets = Insets
checks-direction = Direction of travel
checks-eye = Driver’s eye

## Checks: insets

checks-insets-title = Insets in force, and what this survey says
checks-insets-loading = the estimates
checks-insets-table = Insets in force
checks-target = target
checks-in-force = in force
checks-from = from
checks-inset-and-u = inset, u of the mean
checks-moves = moves a typical height by
checks-insets-note = An inset used here counts for measurements made from now on; those that are stored keep theirs until they are computed again. Its u is that of a single vehicle: the mean’s, and how much vehicles differ among themselves.
checks-by-known_heights = manufacturers’ heights
checks-by-trend = trend with distance
checks-by-two_frames = two-frame measurements
checks-measurements = { $count ->
    [one] { $count } measurement
   *[other] { $count } measurements
}
checks-other-insets = and { NUMBER($count) } on another spot
checks-estimate = estimate
checks-vehicles = { $count ->
    [one] { $count } vehicle
   *[other] { $count } vehicles
}
checks-vehicles-without = { $count ->
    [one] { $count } vehicle
   *[other] { $count } vehicles
} <without>without { $left_out }</without>
checks-left-out-help = They do not fit the others; look at their clicks and heights.
checks-spread = { $spread } between vehicles
checks-use = { $target ->
    [roof] Use { $inset } (u = { $u_inset }) for roofs
    [driver_eye_near] Use { $inset } (u = { $u_inset }) for near drivers’ eyes
    [driver_eye_far] Use { $inset } (u = { $u_inset }) for far drivers’ eyes
    [taillight] Use { $inset } (u = { $u_inset }) for taillights
    [headlight] Use { $inset } (u = { $u_inset }) for headlights
   *[other] Use { $inset } (u = { $u_inset }) for other targets
}
checks-used = { $target ->
    [roof] The inset of roofs is changed for new measurements; stored ones keep theirs.
    [driver_eye_near] The inset of near drivers’ eyes is changed for new measurements; stored ones keep theirs.
    [driver_eye_far] The inset of far drivers’ eyes is changed for new measurements; stored ones keep theirs.
    [taillight] The inset of taillights is changed for new measurements; stored ones keep theirs.
    [headlight] The inset of headlights is changed for new measurements; stored ones keep theirs.
   *[other] The inset of other targets is changed for new measurements; stored ones keep theirs.
}

## Checks: what the inset is

checks-inset-what = What the inset is
checks-inset-title = What the inset is, and why it matters
checks-inset-plane = A height is read where the line of sight meets the <strong>side plane</strong>: the upright plane through the tyre’s contact with the road, along the traffic. A roof edge or a driver’s eye lies behind that plane, by its <strong>inset</strong>. Read on the plane, a target below the camera seems too high, and one above it too low.
checks-inset-formula = read − true = (H<sub>c</sub> − h) · inset / (D + inset)
checks-inset-symbols = H<sub>c</sub> is the camera’s height, h the target’s, D the distance from the camera to the side plane. A camera as high as its target does not mind the inset. Every stored height is corrected for it; the uncorrected one is kept beside it.
checks-missing-inset = What a missing inset does to a height
checks-missing-inset-caption = How much too high a target reads without its inset, for the camera at { $camera_height }
checks-height = height
checks-inset = inset
checks-at = at { $distance }
checks-drawing = Cross-section of the road. The camera looks down at a target that lies behind the side plane through the tyre; its ray meets the plane higher up than the target is.
checks-drawing-camera = camera
checks-drawing-side-plane = side plane
checks-drawing-inset = inset
checks-drawing-read = read here
checks-drawing-target = the target
checks-drawing-too-high =
    too
    high

## Checks: the direction of travel

checks-vehicles-loading = the vehicles
checks-no-vehicles-title = No vehicles yet
checks-no-vehicles = The direction of travel comes from the tyres of vehicles whose passes are marked.
checks-mark-passes = Mark the passes
checks-withdraw = Withdraw the tyres
checks-previous = Previous
checks-next = Next
checks-no-pose = This recording has no road pose yet.
checks-no-pose-link = Clicks need this recording’s road pose; <link>find the road</link> first.
checks-turned-road = The road as the turned pose sees it.
checks-replace = Click again to replace it.
checks-choose-vehicle = Choose a vehicle.
checks-first-tyre = Click where the first tyre of the near side touches the road.
checks-second-tyre = Now the other tyre of the same side.
checks-verdict = Verdict
checks-mean = mean
checks-spread-of-vehicles = between vehicles
checks-used-vehicles = used
checks-used-of = { $count ->
    [one] { $count } vehicle of { NUMBER($all) }
   *[other] { $count } vehicles of { NUMBER($all) }
}
checks-turned-from = This pose was turned by { $turned } from pose { $pose }.
value-u = { $value } (u { $u })
checks-turn-by = Turn the road axes by { $turn }…
checks-use-before = Use the pose before
checks-turned-pose = Turned pose
checks-turned-by = Turned by { $turn }
checks-turn-no-heights = No stored height is measured with this pose.
checks-turn-heights = { $count ->
    [one] { $count } stored height would differ by up to { $largest } if clicked again; nothing stored changes.
   *[other] { $count } stored heights would differ by up to { $largest } if clicked again; nothing stored changes.
}
checks-differences = Height differences
checks-vehicle = vehicle
checks-turned = turned
checks-turn = Turn
checks-turn-done = The turned pose now holds for new measurements; stored ones keep theirs.
checks-turn-back-done = The pose before the turn holds again.
checks-heading = heading
checks-u = u
checks-apart = apart
checks-two-frames = from two frames
checks-tyres = tyres of vehicle { $vehicle }
checks-withdrawal = withdrawal of the tyres of vehicle { $vehicle }
checks-tyres-none = none
checks-tyres-at = frame { $frame }, at { $first } and { $second } px

## Measure: the page

measure-loading = the frame
measure-none-title = No recording to measure yet
measure-none = Heights are measured on the frames of a recording. Add the day's videos first; they can be measured as soon as they are read.
measure-add-recordings = Add recordings
measure-last-pass = This is the last pass in the list.
measure-first-pass = This is the first pass in the list.
measure-all-passes-done = Every pass of this survey is measured.
measure-other-tab = This vehicle is open in another tab too; if both change it, you will be asked.

## Measure: the passes

measure-passes = Passes
measure-passes-open = Passes <muted>{ NUMBER($count) } to do</muted>
measure-passes-show = Show
measure-passes-order = Order
measure-passes-none = No passes yet. Let them be found, or go to the first frame of a vehicle and mark it.
measure-passes-none-in-state = No pass is in this state.
measure-progress = { NUMBER($count) } of { NUMBER($all) }
measure-pass-begins = The pass begins on this frame
measure-pass-begin = New pass here
measure-pass-ends = The pass ends on this frame
measure-pass-end = …ends here
measure-pass-drop = Do not add a pass
measure-pass-frames = { $count ->
    [one] { $count } frame
   *[other] { $count } frames
}
measure-pass-marked = The pass begins at frame { $frame }; go to its last frame and mark it too.
measure-pass-new = New pass
measure-pass-new-short = new
measure-pass-found = found
measure-pass-title = Pass { $vehicle }: frames { $first_frame } to { $last_frame }
measure-pass-title-more = Pass { $vehicle }: frames { $first_frame } to { $last_frame }, { $more }
measure-way-right = to the right
measure-way-left = to the left
measure-unconfirmed = found by the search, not yet confirmed
measure-unconfirmed-way = { $way ->
    [right] to the right, found by the search, not yet confirmed
   *[left] to the left, found by the search, not yet confirmed
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
measure-pass-no-next = No pass of this recording begins after this one, so there is none to join it with.
measure-pass-delete-of = Delete the pass of vehicle { $vehicle }
measure-pass-delete-title = Delete vehicle { $vehicle }?
measure-pass-delete-body = { $count ->
    [0] Vehicle { $vehicle } leaves the list. Undo brings it back.
    [one] Vehicle { $vehicle } leaves the list, and its { $count } measurement with it. Undo brings it back.
   *[other] Vehicle { $vehicle } leaves the list, and its { $count } measurements with it. Undo brings it back.
}
measure-pass-delete = Delete the pass
measure-pass-bring-back = Bring the pass back
measure-pass-kept = This is kept here and will be done when the connection is back.
measure-pass-new-frames = frames { $first_frame } to { $last_frame }

## Measure: what undo and redo name

measure-step-of = { $step }, vehicle { $vehicle }
measure-step-vehicle = facts of vehicle { $vehicle }
measure-step-new-pass = new pass { $vehicle }
measure-step-deletion = deletion of vehicle { $vehicle }
measure-step-split = split of vehicle { $vehicle }
measure-step-joining = joining of vehicles { $vehicle } and { $next }
measure-step-contact = contact point
measure-step-proposals = confirmed proposals
measure-step-contact-removal = removal of the contact
measure-step-move = move of a point
measure-step-inset = inset
measure-step-new = { $target ->
    [roof] new roof
    [driver_eye] new driver's eye
    [taillight] new taillight
    [headlight] new headlight
   *[other] new other
}
measure-step-withdrawal = { $target ->
    [roof] withdrawal of roof
    [driver_eye] withdrawal of driver's eye
    [taillight] withdrawal of taillight
    [headlight] withdrawal of headlight
   *[other] withdrawal of other
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
   *[unknown] which side is the driver?
}
measure-find-pose = Find the road pose
measure-no-pose = This recording has no road pose yet, so nothing can be measured on it.
measure-choose-pass = Choose a pass on the left, or mark a new one with [ and ].
measure-look-only = You may look, not measure.
measure-vehicle-done = All that is asked for is answered; 1 to 5 measure again.
measure-next-pass = Next pass
measure-choose-target = Choose a target: 1 to 5.
measure-drift = The camera had moved by { $moved_px } px since its road pose. <link>Take a new pose or decide</link>
measure-drift-off = The camera had moved by { $moved_px } px since its road pose, heights here are off by up to { $off }. <link>Take a new pose or decide</link>
measure-proposal-looking = Looking for the wheel…
measure-proposal-take = { $proposal }. Enter or a click on it takes it.
measure-proposal-no-pass = Choose a pass first; then a contact can be proposed.
measure-axes-awaited = axes on their way…
measure-proposal-no-contact = No contact is awaited here; begin a new one with the key for a new contact point.
measure-proposal-no-pointer = Point at where the tyre meets the road, then ask for a proposal.

## Measure: what Sightline proposes to click

measure-propose = Propose points
measure-propose-title = Looks at every found pass of this recording and proposes where to click; what was proposed before is replaced, and nothing is measured
measure-propose-failed = The proposals failed; try again.
measure-propose-cancelled = The work on proposals for { $recording } was cancelled; those from before stay.
measure-propose-over = { $recording }: the proposals are made.
measure-proposed = Proposed, not measured: Enter confirms, a point’s key goes to it.
measure-proposed-awaited = Proposed, not measured: the heights are on their way…
measure-proposed-selected = Drag the point or use the arrow keys; Enter confirms all, its key again turns it down.
measure-proposed-mark = { $what }, proposed
measure-proposed-title = Proposals
measure-proposed-contact = Contact
measure-proposed-accept = { $count ->
    [one] Confirm 1 target
   *[other] Confirm { $count } targets
}
measure-proposed-accept-title = Makes measurements of the proposed points as they stand, in your name
measure-proposed-on-frame = Proposals on frame { $frame }
measure-proposed-go = Go to this point, to look at it and move it
measure-proposed-expected = u = { $expected_px } px
measure-proposed-expected-title = Standard uncertainty that is expected of this point
measure-proposed-doubt = Vehicle { $vehicle }: a height that you confirmed is unusual; look at it again.
measure-proposed-moved = moved by you
measure-points-set = Points
measure-made = { $made ->
    [confirmed] Proposed by Sightline, confirmed
    [moved] Begun from a proposal, finished by hand
   *[clicked] Clicked by hand
}

## Measure: the measurements of a vehicle

measure-measurements = Measurements
measure-target = Measure: { $target }
measure-target-afresh = Measure afresh: { $target }
measure-afresh = { $target ->
    [roof] Roof is measured afresh; the click before stays in its history.
    [driver_eye] Driver's eye is measured afresh; the click before stays in its history.
    [taillight] Taillight is measured afresh; the click before stays in its history.
    [headlight] Headlight is measured afresh; the click before stays in its history.
   *[other] Other is measured afresh; the click before stays in its history.
}
measure-show-point = Show and select the point
measure-click = click on the frame
measure-details-show = { $target ->
    [roof] Show the details of roof
    [driver_eye] Show the details of driver's eye
    [taillight] Show the details of taillight
    [headlight] Show the details of headlight
   *[other] Show the details of other
}
measure-details-hide = { $target ->
    [roof] Hide the details of roof
    [driver_eye] Hide the details of driver's eye
    [taillight] Hide the details of taillight
    [headlight] Hide the details of headlight
   *[other] Hide the details of other
}
measure-discard = Discard
measure-doubt = { $kind ->
    [above_roof] This lies above the roof ({ $low }): is the point on the right feature of this vehicle?
    [below_lamp] The headlight lies higher ({ $low }): is the point on the driver’s eye?
    [far_from_maker] The manufacturer says { $low }: are the points, and make and model, those of this vehicle?
   *[outside_class] Vehicles of this kind lie between { $low } and { $high }: are the points and the category right?
}
measure-not-yet-saved = not yet saved…
measure-not-stored = not stored
measure-click-again = Click it again.
measure-click-again-key = Click it again ({ $key }).
measure-no-way-back = This could not be taken back.
measure-clicked-on = clicked on frame { $frame }
measure-contact = Contact
measure-point = Target
measure-distance = Distance
measure-lateral = Tyre across the road, from the board
measure-along = Tyre along the road, from the board
measure-without-inset = Without inset
measure-withdraw = Withdraw
measure-px = { $across_px }, { $down_px } px
measure-inset = Inset
measure-inset-u = u
measure-estimate = estimate
measure-inset-solved = not used while several frames are clicked: they solve for it
measure-inset-what = how far the target lies behind the side of the vehicle
measure-inset-as-survey = As the survey has it: { $inset } (u = { $u_inset })
measure-inset-side = The driver sits on the
measure-unseen = Not visible: { $why }.
measure-unseen-back = It is
measure-unseen-ask = Not visible …
measure-unseen-why = { $target ->
    [roof] Why is the roof not visible?
    [driver_eye] Why is the driver's eye not visible?
    [taillight] Why is the taillight not visible?
   *[headlight] Why is the headlight not visible?
}
measure-side-unknown = not known
measure-side-as-survey = as the survey says
measure-side-from = { $from ->
    [said] said of this vehicle
    [direction] { $direction ->
        [right] goes to the right
       *[left] goes to the left
    }, wheel on the { $steering ->
        [right] right
       *[left] left
    }
    [place] no direction known: from the median all go one way
    [undirected] no direction known, so the eye has no height: say near or far here, or which way the vehicle goes
   *[unknown] not known yet, so the eye has no height: say it here for this vehicle, or on the survey’s page for all
}
measure-inset-roof = Clicked on the roof: its
measure-inset-now = inset { $inset } (u = { $u_inset }), estimate

## Measure: several frames

measure-second-looking = Looking for the frame that gains most …
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
    [driver_eye] click the same driver's eye point
    [taillight] click the same taillight point
    [headlight] click the same headlight point
   *[other] click the same other point
}
measure-second-hint-care = { $hint }. { $care }
measure-second-nothing-yet = Measure a target first; then a second frame can be clicked.
measure-second-no-use = No other frame would help.
measure-second-clicked-already = This frame is clicked already; go to another one of the pass.
measure-second-expected = expected about here
measure-second-expected-at = at { $speed }
measure-frames-said = { $count ->
    [one] From { $count } frame
   *[other] From { $count } frames
}
measure-frames-said-inset = { $count ->
    [one] From { $count } frame; inset { $inset }, u { $u_inset }
   *[other] From { $count } frames; inset { $inset }, u { $u_inset }
}
measure-frame = Frame { $frame }
measure-frame-first = first
measure-frame-remove = Remove frame { $frame }
measure-frame-remove-this = Remove this frame
measure-frame-removed = { $count ->
    [one] Frame { $frame } is taken away; { $count } frame left.
   *[other] Frame { $frame } is taken away; { $count } frames left.
}
measure-one-frame = One frame
measure-all-frames = { $count ->
    [one] { $count } frame
   *[other] { $count } frames
}
measure-gain-looking = { $which ->
    [second] Second frame gains: looking …
   *[another] Another frame gains: looking …
}
measure-gain = { $which ->
    [second] Second frame gains: { $U95_now } → { $U95_then }
   *[another] Another frame gains: { $U95_now } → { $U95_then }
}
measure-gain-go = Go to frame { $frame } and click the same two points

## Measure: the vehicle

measure-vehicle = Vehicle
measure-vehicle-number = Vehicle { $vehicle }
measure-vehicle-none = Choose a pass on the left. Its vehicle and measurements appear here.
measure-save-again = Save again
measure-record = Vehicle record
measure-facts-of = facts of vehicle { $vehicle }
which-model-title = Models that fit
which-model-cannot = { $model } cannot fit: { $differences } (measured minus catalogue). The right model would differ this much with a chance of { $p }; the limit is { $limit }.
which-model-row-cannot = cannot fit, p { $p }
which-model-height = roof
which-model-length = length
which-model-width = width
which-model-wheelbase = wheelbase
which-model-taillight = taillight
which-model-headlight = headlight
measure-makers-height = Manufacturer’s height
measure-makers-height-u = its u
measure-year-problem = A year has four digits.
measure-span = Frames of the pass
measure-span-first = First
measure-span-best = Best
measure-span-last = Last
measure-span-first-here = Begin here
measure-span-best-here = Best here
measure-span-last-here = End here
measure-span-elsewhere = Another recording is open.
measure-span-frame-problem = Give a frame number.
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
measure-field-category = Category
measure-field-manufacturer_height_m = Manufacturer’s height
measure-field-u_manufacturer_height_m = u of the manufacturer’s height
measure-field-height_source = Source of the height
measure-field-lighting = Lighting
measure-field-direction = Goes
measure-field-driver_side = Driver’s side
measure-field-roof_not_visible = Roof not visible
measure-field-driver_eye_not_visible = Driver’s eye not visible
measure-field-taillight_not_visible = Taillight not visible
measure-field-headlight_not_visible = Headlight not visible
measure-field-discarded = Pass
measure-in-sample = in the sample
measure-out-of-sample = out of the sample, by the survey’s rule
measure-discard-measured = Withdraw its measurements to discard it.
measure-fact = { $field ->
    [first_frame] first frame { $value }
    [best_frame] best frame { $value }
    [last_frame] last frame { $value }
    [make] make { $value }
    [model] model { $value }
    [year] year { $value }
    [category] category { $value }
    [manufacturer_height_m] manufacturer’s height { $value }
    [u_manufacturer_height_m] u of the manufacturer’s height { $value }
    [height_source] source of the height { $value }
    [lighting] lighting { $value }
    [direction] goes { $value }
    [driver_side] driver on the { $value }
    [roof_not_visible] roof not visible: { $value }
    [driver_eye_not_visible] driver's eye not visible: { $value }
    [taillight_not_visible] taillight not visible: { $value }
    [headlight_not_visible] headlight not visible: { $value }
    [discarded] { $value }
   *[notes] notes { $value }
}
measure-fact-empty = empty
measure-deleted = deleted
measure-merged = { $problem } Your changes are to other fields, so both are kept.
measure-conflict = Changed by somebody else
measure-conflict-kept = Both versions are kept until you choose.
measure-conflict-mine = mine: { $value }
measure-conflict-theirs = theirs: { $value }
measure-conflict-save = Save this
measure-conflict-both = Theirs ({ $person }): { $theirs }. Yours: { $mine }.
measure-conflict-somebody = somebody

## Review: the page

review-loading = the queue
review-back-to-frame = Back to frame { $frame }
review-none-in-state-title = Nothing in this state
review-none-in-state = Choose another state in the list on the left.
review-all-done-title = Everything is reviewed
review-all-done = Each measurement has a verdict. New and corrected ones appear here by themselves.
review-to-export = Go to the export
review-none-title = Nothing to review yet
review-none = Measurements appear here as soon as an operator has clicked them.
review-to-measure = Go to measuring
review-other-point = Choose the other point
review-other-frame = Another frame than the one that was clicked.
review-fix-hint = Drag the points, or choose one with { $key } and nudge it; Enter saves the fix, Esc leaves it.

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
review-mine = mine
review-line = line scan
review-lines = { $count ->
    [one] { $count } height of a line scan to review.
   *[other] { NUMBER($count) } heights of line scans to review.
}
review-lines-left-title = Heights in line scans wait
review-lines-left = They are judged on the bench of line scans, which goes on from one to the next.
review-lines-open = Open the next one
review-verdict-of = verdict on { $target } of vehicle { $vehicle }
review-verdict-reason = { $verdict }: { $reason }
review-verdict-by = { $verdict } by { $person }
review-verdict-none = no verdict
review-verdict-kept = The verdict is kept here and will be stored when the connection is back.

## Review: clicking again before the points are seen

review-plan = { $one_in ->
    [0] The survey’s plan: none is clicked blind.
    [1] The survey’s plan: each is clicked blind before it is shown.
   *[other] The survey’s plan: 1 in { $one_in } is clicked blind before it is shown.
}
review-plan-choose = Clicked blind, for everybody who reviews this survey
review-plan-choice = { $one_in ->
    [0] none blind
    [1] all blind
   *[other] 1 in { $one_in } blind
}
review-blind-click = click it again
review-blind-title = Click it again first
review-blind-contact = Click the tyre's contact, then the target. The points and the height are shown afterwards, beside yours.
review-blind-target = Now the target. Esc takes the contact back.
review-blind-why = Two clicks that do not know of each other tell how well people click. The survey’s plan draws which; what cannot be clicked is rejected with its reason.
blind-kept = Your second click is kept here and will be stored when the connection is back.
review-again = Clicked again
review-again-you = <strong>You</strong> clicked it again: <height>{ $height }</height>
review-again-person = <strong>{ $person }</strong> clicked it again: <height>{ $height }</height>
review-again-somebody = <strong>Somebody</strong> clicked it again: <height>{ $height }</height>
review-again-take-back = Take it back
review-again-agree = agree: { $apart } apart, expected within { $expected }
review-again-differ = differ by { $apart }, expected within { $expected }
review-again-not-compared = not compared

## Review: what is known of a measurement

review-measurement = Measurement
review-facts = Facts and history
review-contact = contact
review-pixels = { $point ->
    [contact] Pixels around the contact point
    [roof] Pixels around the roof point
    [driver_eye] Pixels around the driver's eye point
    [taillight] Pixels around the taillight point
    [headlight] Pixels around the headlight point
   *[other] Pixels around the other point
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
review-clicked-by = Clicked by

## Review: the verdict

review-look-only = You may look; a reviewer gives the verdict.
review-own = You made this measurement, so somebody else reviews it.
review-pose-changed = The recording has another road pose since this was measured; the fix is computed with the new one.
review-fix-save = Save the fix
review-fix-nothing = Nothing is other than it was; move a point first, or accept the measurement.
review-fix-leave = Leave it
review-fix-mine = Fix it with my points
review-reopen = Reopen it
review-reject-why = Why is it rejected?
review-reject-words = In your own words
review-reason-contact = The contact is not where the tyre meets the road.
review-reason-point = The target point is beside the feature.
review-reason-frame = Another frame shows it better.
review-reason-hidden = The feature is hidden.
review-reason-wrong = The wrong vehicle or target.
review-reason-side = The driver sits on the other side.
review-step-verdict = verdict on { $target } of vehicle { $vehicle }
review-error = Error against it
review-side = Driver’s side
review-signs = Look closely
review-sign = { $sign ->
    [large_u] large uncertainty
    [unusual] unusual height in this survey
    [far_from_maker] far from the manufacturer’s height
   *[new_operator] operator with few measurements
}
review-own-waiting = { $count ->
    [one] { $count } of your own waits for somebody else.
   *[other] { $count } of your own wait for somebody else.
}
review-neighbours = A little earlier and later
review-neighbour = Frame { $frame }

## Repeats: the page

repeats-lead = The same targets clicked again without seeing the first clicks: how far a person comes out beside themselves, and how far two people beside each other.
repeats-loading = the repeats
repeats-not-compared = { $count ->
    [one] { $count } repeat
   *[other] { $count } repeats
} with another road pose or inset, or without a height: in none of these figures.
repeats-click-mine = Click 10 of mine again
repeats-click-anybodys = Click 10 of anybody’s again
repeats-none-title = Nothing was clicked again yet
repeats-none = Repeats come from two places: click a random ten again here, each without its points, or a survey’s review plan lets you click before you see. Ten repeats of your own give you a click sigma of your own; repeats of other people’s work tell how far people differ.
repeats-no-result = Repeats stand in no list and change no result.
repeats-to-review = Go to the review
repeats-target = target
repeats-items = { $count ->
    [one] { $count } item
   *[other] { $count } items
}

## Repeats: the table of targets

repeats-targets-title = Heights, by target
repeats-targets-note = standard deviations with their 95 % intervals
repeats-targets-help = One spread for near and far vehicles alike, though in millimetres it grows with the distance. Lens, road pose, board and inset are the same for all clicks on a frame and cancel in their differences, so only the clicks’ part of the budgets is compared. On another frame they do not cancel: step to it while you click again.
repeats-clicked-again = clicked again
repeats-same-person = the same person
repeats-another-frame = … on another frame
repeats-another-person = another person adds
repeats-claimed = clicks’ part, claimed
repeats-seen = clicks’ part, seen
repeats-all-targets = all targets
repeats-people-differ = People differ from vehicle to vehicle by more than their own repeats; “the same person” contains that.
repeats-ratio = × { $ratio } ({ $low } to { $high })
repeats-more = more than claimed
repeats-less = less than claimed
repeats-as = as claimed

## Repeats: the table of people

repeats-people-title = Clicks, by person
repeats-people-note = each coordinate of a click, from people’s repeats of their own
repeats-person = person
repeats-own = own repeats
repeats-contact = contact
repeats-height = height
repeats-against-others = against others
repeats-sigma = clicks count with
repeats-sigma-usual = 1 px, as usual
repeats-sigma-own = { $sigma_px } px of their own
repeats-sigma-from = { $count ->
    [one] from { $count } repeat, chosen by { $person }
   *[other] from { $count } repeats, chosen by { $person }
}
repeats-sigma-use = Use { $sigma_px } px
repeats-sigma-use-title = { $count ->
    [one] From { $count } repeat; clicks that are stored keep theirs
   *[other] From { $count } repeats; clicks that are stored keep theirs
}
repeats-sigma-needs = ten own repeats are needed for another
repeats-sigma-back = Back to 1 px

## Repeats: the figure of differences

repeats-differences-title = Second minus first height, over their mean
repeats-differences-note = Each bar is what the budgets of both clicks let one expect (k = 2): about 19 in 20 should reach zero.
repeats-differences-label = { $count ->
    [one] Second minus first height in { $small } over their mean in { $unit }, { $count } repeat
   *[other] Second minus first height in { $small } over their mean in { $unit }, { $count } repeats
}
repeats-differences-x = mean of both heights ({ $unit })
repeats-differences-y = difference ({ $unit })

## Click again: measurements once more, without their points

again-loading = what to click again
again-place = <strong>{ $at } of { $of }</strong> <muted>vehicle { $vehicle }, { $target }</muted>
again-stored = { $count ->
    [one] { $count } repeat stored
   *[other] { $count } repeats stored
}
again-stop = Stop
again-undo = Take the last back
again-undo-clicks = second clicks
again-undo-skip = passing over
again-skip = Pass over
again-results = See what they say
again-back-to-frame = Back to frame { $frame }
again-last-title = That was the last one
again-last = Each was stored as a repeat: it stands in no list and changes no result.
again-none-own-title = You have clicked nothing yet
again-none-title = Nothing is measured yet
again-none-own = How well you repeat yourself shows once you have measured something in this survey.
again-none = Measure some vehicles first; then they can be clicked again.
again-to-measure = Go to measuring

## Line scans: the page

scans-lead = Two line cameras a known baseline apart: speed, length, acceleration and the gaps between vehicles, with the picture to check each by.
scans-loading = the line scans
scans-plan = Plan the line rate
scans-results = Results
scans-add = Add a line scan
scans-all = All line scans
scans-none-title = No line scans yet
scans-none = An operator can upload the strips of both cameras here.
scans-delete-title = Delete { $scan }?
scans-delete-what = Both strips and what was found in them go; a line scan on which somebody worked cannot be deleted.
scans-delete = Delete the line scan
scans-delete-one = Delete { $scan }
scans-deleted = { $scan } was deleted.
scans-read-again = Read it again
scans-not-read = The strips could not be read.
scans-rig = The rig, and what the traffic says of it
scans-rig-change = Change the rig…
scans-open = Open the bench
scans-fact-lines = { $lines ->
    [one] { $lines } line of { $rows_px } rows
   *[other] { $lines } lines of { $rows_px } rows
}
scans-fact-baseline = baseline { $baseline }
scans-fact-rate = { $rate_hz } lines a second
scans-fact-video = cut from a video at columns { $column_1_px } and { $column_2_px }
scans-count-none = vehicles not looked for yet
scans-count-vehicles = { $count ->
    [one] { $count } vehicle
   *[other] { $count } vehicles
}
scans-count-to-review = { NUMBER($count) } to review
scans-count-accepted = { NUMBER($count) } accepted
scans-count-rejected = { NUMBER($count) } rejected
scans-count-not-measurable = { NUMBER($count) } not measurable
scans-count-heights = { $count ->
    [one] { $count } height
   *[other] { NUMBER($count) } heights
}
scans-count-heights-to-review = { $count ->
    [one] { $count } height to review
   *[other] { NUMBER($count) } heights to review
}

## Line scans: what a line scan cannot measure

scans-limits = What a line scan cannot measure
scans-limit-opposing = Opposing direction
scans-limit-opposing-why = A pair measures the direction that reaches camera 1 first; a vehicle that comes the other way is told and left out. For the other lane add a second line scan of the same strips with the cameras the other way round, and that lane’s baseline and distance.
scans-limit-abreast = Side by side
scans-limit-abreast-why = Two vehicles that hide each other share their lines, so neither has a front and a rear of its own. Only their passing one after the other helps: a lane farther away, or a steeper view from above.
scans-limit-slow = Stopped, turned back, or very slow
scans-limit-slow-why = Along a strip runs time, not way. A vehicle that stands paints the same line again and again, and the fit takes one constant acceleration from front to rear; stop-and-go traffic has none.
scans-limit-cut = Cut off, or lines lost
scans-limit-cut-why = What began before the recording or ended after it has no front or no rear; where the recorder lost lines the clock of the strip is wrong.
scans-limit-distance = Another distance than the lane’s
scans-limit-distance-why = Planes that are not quite parallel make the baseline longer or shorter with the distance; the traffic alone cannot tell that. Enter the divergence’s uncertainty and the lane’s distance under Rig.

## Line scans: adding one

scans-new = A new line scan
scans-new-from = Where it comes from
scans-new-strips = Two strips
scans-new-columns = Two columns of a video
scans-new-name-hint = Left empty, the file's name is taken.
scans-new-read = Read it and find the vehicles
scans-new-no-strip = no strip is here yet
scans-new-choose-strip = choose a strip
scans-new-strip = { $file } ({ $size })
scans-new-choose-both = Choose both strips
scans-new-drop = Drop both strips here, or click to choose
scans-new-drop-hint = PNG, TIFF or BigTIFF, 8 or 16 bits, grey; hours long if need be.
scans-new-camera-1 = Camera 1, which a vehicle reaches first
scans-new-camera-2 = Camera 2
scans-new-same-strip = Both cameras cannot have the same strip.
scans-new-time-axis = Time runs along the picture’s
scans-new-time-width = width, as usual
scans-new-time-height = height
scans-new-no-recording = no recording is ready
scans-new-choose-recording = choose a recording
scans-new-recording-hint = Its frame rate is the line rate, so a steady, fast one.
scans-new-column-1 = Column of camera 1
scans-new-column-1-hint = The column that a vehicle reaches first.
scans-new-column-1-hint-to = The column that a vehicle reaches first, 0 to { $last_px }.
scans-new-column-2 = Column of camera 2

## Line scans: the rig

scans-rig-title = The rig
scans-rig-store = Store
scans-rig-traffic = The rig from the traffic
scans-rig-traffic-title = From the traffic
scans-rig-note = What was measured keeps the values that it was measured with, and says so, until it is measured again.
scans-rig-undo = the rig
scans-rig-stored = The rig’s values were stored.
scans-rig-stored-older = The rig has other values now; find the vehicles again to bring the results up.
scans-rig-baseline = Baseline
scans-rig-baseline-hint = Between the two scanning planes, at the vehicles.
scans-rig-u = Its standard uncertainty
scans-rig-baseline-u-hint = A speed is never better known than this.
scans-rig-rate = Lines a second
scans-rig-clock = Clock’s uncertainty
scans-rig-clock-hint = A quartz keeps about 50 ppm.
scans-rig-more = More: misalignment, divergence, distance of the lane
scans-rig-misalignment = Misalignment
scans-rig-from-traffic = from the traffic
scans-rig-misalignment-hint = Row of a point in strip 2 minus its row in strip 1. Empty: estimated from the traffic, vehicle by vehicle.
scans-rig-divergence = Divergence of the planes
scans-rig-divergence-hint = Positive: they open towards the vehicles. The baseline is then the one at the cameras.
scans-rig-divergence-u-hint = Planes that were set parallel: what the setting leaves.
scans-rig-distance = Distance of the lane
scans-rig-distance-hint = From the cameras to the vehicles’ near side. Needed for the divergence only.
scans-rig-problem-number = Enter a number of 0 or more, or leave it empty.
scans-rig-problem-length = Enter a length, or leave it empty.
scans-rig-problem-angle = Enter an angle of at most 200 mrad, or leave it empty.
scans-rig-problem-baseline = Enter the distance between the two scanning planes.
scans-rig-problem-rate = Enter how many lines the cameras make a second.
scans-rig-problem-misalignment = Enter pixels, or leave it empty.
scans-rig-problem-distance = Enter how far the lane is, or leave the divergence empty: it counts over this distance.
scans-rig-problem-misalignment-u = Enter the misalignment too, or leave its uncertainty empty.

## Line scans: the rig as the traffic says it

scans-traffic-loading = what the traffic says
scans-traffic-swapped = The cameras were exchanged; the vehicles are being found again.
scans-traffic-swap = Swap the cameras
scans-traffic-table = The rig as the traffic says it
scans-traffic-says = the traffic says
scans-traffic-value = value and u
scans-traffic-from = from
scans-traffic-in-force = in force
scans-traffic-take = take it over
scans-traffic-gain = Light, camera 2 over 1
scans-traffic-gain-own = each vehicle’s own
scans-traffic-baseline = { $of ->
    [length] Baseline by lengths
   *[wheelbase] Baseline by wheelbases
}
scans-traffic-note = u is the standard uncertainty. Nothing here is in force by itself: “Use…” fills it in, and you store it.
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
scan-nothing-found = Look at the strips: where a vehicle is seen, add it by two clicks, on its front and on its rear.
scan-nothing-yet = Let them be found: front, rear, speed, length and the gaps between them come by themselves.
scan-find-now = Find the vehicles
scan-none-title = No line scan is chosen
scan-none-choose = Choose one
scan-on = On along the strips
scan-back = Back along the strips
scan-on-window = On by a window
scan-back-window = Back by a window
scan-to-first = To the first line
scan-to-last = To the last line
scan-next-vehicle = Next vehicle
scan-previous-vehicle = Previous vehicle
scan-take-out-vehicle = Take the vehicle out
scan-last-vehicle = This is the last vehicle.
scan-first-vehicle = This is the first vehicle.
scan-search-stopped = The search stopped.

## Line scan: finding the vehicles

scan-find-title = Find the vehicles
scan-find-and-measure = Find and measure
scan-find-again = Measure again
scan-find-method = Method
scan-find-direct = Direct registration
scan-find-paper = The paper’s method
scan-find-direct-what = Both strips of a vehicle are laid over each other as a whole: speed, acceleration and the cameras' misalignment in one fit. The default.
scan-find-paper-what = Block matching and a linear regression, as Douxchamps, Macq and Chihara published it; to compare with.
scan-find-what = What
scan-find-all = Look through the whole recording
scan-find-known = Measure the known vehicles again
scan-find-note = Boundaries that somebody placed stay, and so does what was taken out. Every result is a revision of its own; accepted ones that change are to be reviewed again.

## Line scan: the strips, and what the next click is to hit

scan-strips = line-scan strips
scan-strips-label = Camera 1 above, camera 2 below, time to the right
scan-camera-1 = camera 1
scan-camera-2 = camera 2
scan-strips-missing = Some of the picture could not be fetched.
scan-asked = { $what } (Esc stops)
scan-asked-stretch = { $what } (R stretches, Esc stops)
scan-click-camera-1 = Click on camera 1, the upper strip.
scan-click-rod-distance = Enter the rod's distance on the right
scan-click-rod = Click the rod { $distance } away, { $height } above the road
scan-click-tyre = Click where a tyre stands on the road, on camera 1
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
scan-click-front = Click the vehicle's front on camera 1
scan-click-rear = Click the vehicle's rear on camera 1
scan-drawn-height = { $target } { $height }
scan-drawn-away = { $distance } away
scan-drawn-mark-away = { $height }, { $distance } away

## Line scan: the table of vehicles

scan-head-number = no.
scan-head-time = time
scan-head-speed = speed
scan-head-acceleration = acc.
scan-head-length = length
scan-head-gap = gap
scan-head-headway = headway
scan-head-state = state
scan-choose-vehicle = { $vehicle } <hidden>choose</hidden>

## Line scan: the chosen vehicle

scan-vehicle = Vehicle
scan-vehicle-none = Choose a vehicle in the list or in the picture{ $key }: its motion, the fit and the gaps come here.
scan-vehicle-body = Motion and history
scan-fit-loading = the fit
scan-motion = Motion
scan-not-measurable = Not measurable
scan-older = Measured with other values of the rig than the recording has now; measure again to bring it up.
scan-length = Length
scan-acceleration = Acceleration
scan-wheelbase = Wheelbase
scan-wheelbase-none = not clicked
scan-time-gap = Time gap
scan-time-gap-first = the first vehicle
scan-distance-gap = Distance gap
scan-distance-gap-paper = { $gap } <muted>(by mean speed { $paper_gap })</muted>
scan-headway = Headway
scan-by = By
scan-cause = { $method ->
    [paper] the paper's method
   *[direct] direct registration
}
scan-cause-by-hand = { $method ->
    [paper] the paper's method, boundaries placed by hand
   *[direct] direct registration, boundaries placed by hand
}
scan-cause-scatter = { $cause }; scatter of the blocks { $percent } %
scan-misalignment = Misalignment
scan-misalignment-u = { $value_px } px (u { $u_px } px)
scan-show = Show
scan-show-title = Fill the window
scan-wheels = Click the wheels
scan-wheels-again = Click the wheels again
scan-wheels-title = Click both hubs
scan-heights-measure = Measure heights
scan-heights-title = Click a tyre's contact, then roof, eye and lamp
scan-take-out = Take out
scan-take-out-title = Take the vehicle out

## Line scan: what is known of a vehicle, its budget and its history

scan-known = What is known of the vehicle
scan-known-make = Make
scan-known-model = Model
scan-known-length = True length
scan-known-wheelbase = True wheelbase
scan-known-problem = This is no length.
scan-known-off = measured { $difference }
scan-budget-note = standard uncertainties
scan-budget = Budget
scan-budget-source = source
scan-budget-speed = speed
scan-budget-acceleration = acceleration
scan-budget-length = length
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
scan-by-search = the search
scan-by-program = the program
scan-by-somebody = somebody
scan-by-nobody = nobody

## Line scan: the fit of a vehicle

scan-profile-title = Speed along the vehicle
scan-profile-says = { $count ->
    [one] Speed of { $count } block along vehicle { $vehicle } and the fitted motion
   *[other] Speed of { $count } blocks along vehicle { $vehicle } and the fitted motion
}
scan-profile-none = There is no speed profile, since the vehicle has no measured motion.
scan-profile-fitted = fitted motion
scan-profile-used = block, used
scan-profile-left-out = block, left out
scan-profile-note = Each block's mean speed between the cameras.
scan-profile-beyond = { $count ->
    [one] { $count } block lies outside this picture; the CSV has all of them.
   *[other] { $count } blocks lie outside this picture; the CSV has all of them.
}
scan-profile-x = time after the front reached camera 1 (s)
scan-match-title = Strip 2 laid over strip 1
scan-match-picture = Picture of the match
scan-match-1 = 1
scan-match-2 = 2
scan-match-blink = blink
scan-match-difference = difference
scan-match-alt-1 = The vehicle on camera 1
scan-match-alt-2 = The vehicle on camera 2
scan-match-alt-difference = Difference of the two strips; even grey where they agree
scan-match-note = Strip 2 is moved by the fitted speed and acceleration. Even grey: the same in both; wheels turn and what shines through windows stays behind, so they show.

## Line scan: the verdict

scan-reason-boundary = A boundary is not where the vehicle begins or ends.
scan-reason-not-one = It is not one vehicle.
scan-reason-match = The strips do not match.
scan-verdict-mine = You placed these boundaries, so somebody else reviews them.
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
scan-verdict-none-left = Nothing else of this line scan waits for your verdict.
scan-verdict-reopen = Reopen
scan-verdict-accept = Accept
scan-verdict-reject = Reject
scan-verdict-reject-why = Reject…
scan-verdict-reason = Why it is rejected
scan-verdict-leave = Leave it

## Line scan: heights

scan-heights = Heights
scan-heights-camera = camera at { $height }
scan-heights-older = { $count ->
    [one] { $count } height of this line scan stand on an earlier calibration.
   *[other] { $count } heights of this line scan stand on an earlier calibration.
}
scan-heights-older-again = Compute them again
scan-heights-no-pose = Heights need the pose of camera 1. Record a rod with marks, or a checkerboard, held upright at two distances in its plane; then click the marks.
scan-heights-calibrate = Calibrate the height
scan-heights-calibrate-first = Heights need the line camera's pose; calibrate the height with a rod first.
scan-height-hide = { $target ->
    [roof] Hide the details of roof
    [driver_eye] Hide the details of driver's eye
    [taillight] Hide the details of taillight
    [headlight] Hide the details of headlight
   *[other] Hide the details of other
}
scan-height-show = { $target ->
    [roof] Show the details of roof
    [driver_eye] Show the details of driver's eye
    [taillight] Show the details of taillight
    [headlight] Show the details of headlight
   *[other] Show the details of other
}
scan-height-measure = { $target ->
    [roof] Measure: roof
    [driver_eye] Measure: driver's eye
    [taillight] Measure: taillight
    [headlight] Measure: headlight
   *[other] Measure: other
}
scan-height-measure-again = { $target ->
    [roof] Measure again: roof
    [driver_eye] Measure again: driver's eye
    [taillight] Measure again: taillight
    [headlight] Measure again: headlight
   *[other] Measure again: other
}
scan-height-verdict-mine = You clicked or computed this height, so somebody else reviews it.
scan-height-verdict-done = Vehicle { $vehicle }, { $target ->
    [roof] roof
    [driver_eye] driver's eye
    [taillight] taillight
    [headlight] headlight
   *[other] other
}: { $verdict ->
    [accepted] accepted.
   *[rejected] rejected.
}
scan-heights-waiting = { $count ->
    [one] { $count } height to review
   *[other] { $count } heights to review
}
scan-height-unsaved = not yet saved…
scan-height-older = Computed with the calibration before; compute it again.
scan-height-again = Compute again
scan-height-withdraw = Withdraw
scan-height-side-first = Say first on which side the driver sits; the eye’s height depends on it.
scan-height-inset-driver_eye = The driver sits on the
scan-height-inset-roof = Clicked on the roof: its
scan-height-distance = Lateral distance
scan-height-inset = Inset
scan-height-inset-value = { $inset } (u = { $u_inset }), estimate
scan-height-rows = Rows
scan-height-rows-value = contact { $contact_px }, target { $target_px }
scan-height-revision = { $height } <muted>{ $person }, { $time }</muted>

## Line scan: the rod, which calibrates the height

scan-rod-title = Calibrate the height
scan-rod-label = Calibration of the height
scan-rod-body = Marks of the rod
scan-rod-none-title = No marks yet
scan-rod-none = Enter how far the rod stood from camera 1, then click its marks from the foot up. Do the same where it stood at another distance.
scan-rod-next = Next mark
scan-rod-distance = Rod's distance
scan-rod-height = Mark's height
scan-rod-step = Then higher by
scan-rod-next-note = Distances run level from the camera's centre. A checkerboard held upright will do as well: “higher by” is then the size of its squares.
scan-rod-marks = Marks
scan-rod-head-distance = distance
scan-rod-head-height = height
scan-rod-head-row = row
scan-rod-head-residual = residual
scan-rod-head-remove = remove
scan-rod-remove = Remove mark { $number }
scan-rod-result = What the marks give
scan-rod-camera-height = Camera's height
scan-rod-residuals = Residuals
scan-rod-rms = { $rms_px } px rms
scan-rod-store = Store the calibration
scan-rod-clear = Remove all marks
scan-rod-reset = Back to what is stored
scan-rod-u = Standard uncertainties
scan-rod-u-row = u of a mark's row
scan-rod-u-distance = u of a distance
scan-rod-u-lean = u of the rod's lean
scan-rod-at-least = A number from { $least }, please.
scan-rod-distance-first = Enter the rod's distance from the camera first, then click its marks.
scan-rod-stored = The calibration is stored. Choose a vehicle and measure its heights.
scan-rod-stored-older = The calibration is stored. Heights keep the one before until they are computed again, beside each vehicle.

## Line scan: steps that can be taken back, and what is kept until it is sent

scan-step-mark = mark of the rod
scan-step-mark-removed = removing a mark
scan-step-marks-removed = removing all marks
scan-step-calibration = calibration of the height
scan-step-boundaries = boundaries of vehicle { $vehicle }
scan-step-wheels = wheels of vehicle { $vehicle }
scan-step-known = what is known of vehicle { $vehicle }
scan-step-take-out = taking out vehicle { $vehicle }
scan-step-vehicle = vehicle { $vehicle }
scan-step-height = { $target ->
    [roof] roof of vehicle { $vehicle }
    [driver_eye] driver's eye of vehicle { $vehicle }
    [taillight] taillight of vehicle { $vehicle }
    [headlight] headlight of vehicle { $vehicle }
   *[other] other of vehicle { $vehicle }
}
scan-step-height-verdict = { $target ->
    [roof] verdict on the roof of vehicle { $vehicle }
    [driver_eye] verdict on the driver's eye of vehicle { $vehicle }
    [taillight] verdict on the taillight of vehicle { $vehicle }
    [headlight] verdict on the headlight of vehicle { $vehicle }
   *[other] verdict on the other height of vehicle { $vehicle }
}
scan-step-withdraw = { $target ->
    [roof] withdrawing the roof of vehicle { $vehicle }
    [driver_eye] withdrawing the driver's eye of vehicle { $vehicle }
    [taillight] withdrawing the taillight of vehicle { $vehicle }
    [headlight] withdrawing the headlight of vehicle { $vehicle }
   *[other] withdrawing the other of vehicle { $vehicle }
}
scan-taken-out = Vehicle { $vehicle } was taken out; Ctrl Z brings it back.
scan-kept-vehicle = The vehicle is kept here, and comes into the list when the connection is back.
scan-wish-a-vehicle = a vehicle
scan-wish-verdict = verdict on vehicle { $vehicle }
scan-wish-lines = front at line { $front }, rear at line { $rear }
scan-wish-clicked = clicked at line { $line }, row { $row }
scan-wish-marks = { $count ->
    [one] { $count } mark at { $distances }
   *[other] { $count } marks at { $distances }
}
scan-wish-no-marks = none
scan-wish-there = in the list
scan-wish-taken-out = taken out
scan-wish-boundaries = boundaries at lines { $lines }
scan-wish-hubs = wheels at lines { $lines }
scan-wish-no-line = none
scan-wish-nothing-known = nothing known
scan-wish-verdict-word = { $verdict ->
    [accepted] accepted
    [rejected] rejected
   *[reopened] reopened
}
scan-wish-verdict-why = { $verdict ->
    [accepted] accepted: { $reason }
    [rejected] rejected: { $reason }
   *[reopened] reopened: { $reason }
}
scan-wish-verdict-by = { $verdict ->
    [to_review] to review by { $person }
    [accepted] accepted by { $person }
    [fixed] fixed by { $person }
    [rejected] rejected by { $person }
   *[reopened] reopened by { $person }
}

## Motion: what the line scans of a survey say together

motion-title = Motion of the vehicles
motion-lead = Speeds, gaps and lengths of every line scan of this survey, and how far known sizes are met.
motion-loading = the statistics
motion-which = Which vehicles count
motion-which-accepted = accepted
motion-which-all = those to review too
motion-none-accepted-title = No vehicle is accepted yet
motion-none-accepted = Review some on the bench, or let those that wait for a review count too.
motion-none-title = No vehicle is measured yet
motion-none = Add a line scan and let its vehicles be found.
motion-counted = { $vehicles ->
    [one] { $vehicles } vehicle
   *[other] { $vehicles } vehicles
} of { $scans ->
    [one] { $scans } line scan
   *[other] { $scans } line scans
}.
motion-heights-target = Target
motion-heights-mean = Mean
motion-heights-sd = SD
motion-heights-median = Median
motion-heights-u95 = Typical U95
motion-heights-to-review = To review
motion-heights-rejected = Rejected
motion-heights-waiting = { $count ->
    [one] { $count } height waits for a verdict
   *[other] { $count } heights wait for a verdict
}
motion-by-lengths = By lengths
motion-by-wheelbases = By wheelbases

## Motion: errors against known sizes

motion-errors-title = Measured minus the manufacturer’s value
motion-errors-note = with 95 % intervals
motion-errors-table = Errors of lengths and wheelbases
motion-errors-of = of
motion-errors-n = n
motion-bias = bias
motion-mae = MAE
motion-rmse = RMSE
motion-sd = SD
motion-length-daytime = Length, daytime
motion-length-low_light = Length, low light
motion-length-overall = Length, overall
motion-wheelbase-daytime = Wheelbase, daytime
motion-wheelbase-low_light = Wheelbase, low light
motion-wheelbase-overall = Wheelbase, overall
motion-errors-none = No vehicle has a known size.

## Motion: distributions

motion-speed = Speed as the front reaches camera 1
motion-length = Length
motion-time-gap = Time gap, rear to front
motion-distance-gap = Distance gap, rear to front
motion-headway = Headway, front to front
motion-percentile = { $percent } %: { $value }
motion-percentile-interval = { $percent } %: { $value } ({ $low } to { $high })
motion-percentile-none = { $percent } %: { $reason }
motion-spread-says = { $count ->
    [one] Cumulative distribution of { $count } vehicle; { $percentiles } { $unit }
   *[other] Cumulative distribution of { $count } vehicles; { $percentiles } { $unit }
}
motion-spread-note = Percentiles with their 95 % intervals, { $unit }: { $percentiles }.

## Motion: the paper's table

motion-paper-title = In the layout of the paper’s Table I
motion-paper-own = This survey's vehicles
motion-paper-printed = The paper's Table I, as printed
motion-head-vehicle = vehicle
motion-head-car = the paper’s car
motion-head-speed = speed
motion-head-acceleration = acc.
motion-head-size = size
motion-head-counter = counter
motion-head-true = true
motion-head-fit-error = fit error (%)

## Statistics: the page

statistics-lead = Errors against known heights, and distributions of what was measured.
statistics-loading = the statistics
statistics-back = Back to the survey
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
statistics-left-out = Left out: { $states }.
statistics-left-out-state = { $state ->
    [to_review] { NUMBER($count) } to review
    [reopened] { NUMBER($count) } reopened
    [rejected] { NUMBER($count) } rejected
    [accepted] { NUMBER($count) } accepted
   *[fixed] { NUMBER($count) } fixed
}
statistics-none-accepted-title = No accepted measurements yet
statistics-none-title = No measurements here
statistics-to-review = Go to the review
statistics-show-to-review = Show those to review
statistics-to-measure = Measure vehicles
statistics-none-accepted = { $count ->
    [one] Only accepted measurements count, and { $count } measurement waits for review.
   *[other] Only accepted measurements count, and { $count } measurements wait for review.
}
statistics-none-filtered = The filter leaves no measurement; widen it.
statistics-none = Measure vehicles and have them reviewed; their figures then appear here.
statistics-eye = Driver’s eye
statistics-taillight = Taillight, lower limit
statistics-headlight = Headlight
statistics-roof = Roof

## Statistics: the filter

statistics-filter = Filter
statistics-filter-state = Review state
statistics-filter-state-all = all
statistics-filter-target = Target
statistics-filter-target-all = all
statistics-filter-lighting = Lighting
statistics-filter-any = any
statistics-filter-operator = Operator
statistics-filter-anybody = anybody
statistics-filter-filmed-from = Filmed from
statistics-filter-filmed-to = Filmed to
statistics-filter-first-day = Measured from (UTC)
statistics-filter-last-day = Measured to (UTC)
statistics-filter-correction = Correction
statistics-correction-inset = inset of each (default)
statistics-correction-shift = mean error (the paper’s)
statistics-correction-none = none (inset 0)
statistics-correction-regression = regression
statistics-correction-deconvolution = deconvolution
statistics-filter-rounding = Error table
statistics-rounding-cm = whole cm (the paper’s)
statistics-rounding-none = not rounded
statistics-filter-surveys = Surveys
statistics-filter-surveys-some = { $count ->
    [one] { $count } survey
   *[other] { $count } surveys
}
statistics-filter-surveys-none = all surveys
statistics-filter-surveys-help = Surveys that count; none chosen: all
statistics-reference-u = u of a reference height
statistics-reference-u-hint = as if within { $limit } either way, all alike
statistics-reference-u-inches = Give a number of inches.
statistics-reference-u-millimetres = Give a number of millimetres.

## Statistics: the error table

statistics-errors-title = Error against manufacturers’ heights
statistics-errors-save = Error table as CSV
statistics-errors-head = error = measured − reference
statistics-bias = bias
statistics-mae = MAE
statistics-rmse = RMSE
statistics-mse = MSE
statistics-sd = SD
statistics-correlation = r(error, height)
statistics-correlation-absolute = r(|error|, height)
statistics-errors-note = Intervals at 95 % below each figure. SD is that of the signed error, n − 1. Not pooled from other figures.
statistics-shares-title = Shares of errors in per cent, with exact 95 % intervals, and skewness
statistics-skewness = skewness
statistics-within = within { $within }
statistics-paper-inconsistent = What is inconsistent in the paper’s printed figures
statistics-paper-note = <strong>{ $group }:</strong> { $note }
statistics-paper-printed = the paper, as printed
statistics-stands-for = stands for { $group }
statistics-no-interval = { $figures }: { $reason }
statistics-reference-part = By itself it makes a correlation of { $correlation } between error and height, which no camera is to blame for (u of the reference { $u_reference }).
statistics-bland-altman = Bland and Altman: bias { $bias } { $unit } ({ $bias_interval }), limits of agreement { $lower } ({ $lower_interval }) and { $upper } { $unit } ({ $upper_interval }), n = { $n }.

## Statistics: the figures of the error

statistics-group-daytime = daytime
statistics-group-low_light = low light
statistics-group-overall = overall
statistics-group-unknown = lighting unknown
statistics-group-n = { $group } n = { $n }
statistics-nothing = Nothing to draw.
statistics-nothing-because = Nothing to draw: { $reason }
statistics-absolute-title = Absolute error, cumulative
statistics-absolute-says = Share of vehicles with an absolute error of at most so much; { $groups }
statistics-absolute-note = Bands at 95 % hold everywhere at once; fewer than 5 vehicles have none. { $groups }.
statistics-absolute-x = absolute error ({ $unit })
statistics-relative-title = Relative error, cumulative
statistics-relative-says = Share of vehicles with an error of at most so many per cent of their height; { $groups }
statistics-relative-note = Absolute error over the reference height. { $groups }.
statistics-relative-x = relative error (%)
statistics-density-title = Signed error, density
statistics-density-says = Density of the signed error; { $groups }
statistics-density-note = Gaussian kernel, bandwidth { $bandwidths }; pointwise 95 % band. { $groups }.
statistics-density-note-rounded = Gaussian kernel, bandwidth { $bandwidths }, at least half of the { $rounding } of rounding; pointwise 95 % band. { $groups }.
statistics-signed-error = signed error ({ $unit })
statistics-density-y = share of vehicles (% per { $unit })
statistics-trend-title = Signed error against the manufacturer’s height
statistics-trend-says = Signed error over the manufacturer’s height of { $count ->
    [one] { $count } vehicle
   *[other] { $count } vehicles
}.
statistics-trend-nothing = Nothing to draw: no vehicle has a reference height.
statistics-trend-x = manufacturer’s height ({ $unit })
statistics-trend-legend = regression, 95 % band
statistics-trend = Slope { $slope } { $small } per { $unit } ({ $slope_interval }), r = { $correlation } ({ $correlation_interval }).
statistics-trend-absolute = Absolute error: r = { $correlation } ({ $correlation_interval }).

## Statistics: one target

statistics-heights = { $count ->
    [one] { $count } height
   *[other] { $count } heights
}
statistics-heights-mean = { $count ->
    [one] { $count } height, corrected mean { $mean }
   *[other] { $count } heights, corrected mean { $mean }
}
statistics-heights-mean-sd = { $count ->
    [one] { $count } height, corrected mean { $mean }, SD { $sd }
   *[other] { $count } heights, corrected mean { $mean }, SD { $sd }
}
statistics-curve-raw = as the paper measures
statistics-curve-corrected = corrected
statistics-legend-raw = as the paper measures (inset 0)
statistics-target-ecdf-title = { $target }, cumulative
statistics-target-ecdf-says = Cumulative distribution of { $target } heights as the paper measures them and corrected, { $count ->
    [one] { $count } vehicle
   *[other] { $count } vehicles
}
statistics-target-ecdf-note = Bands at 95 % hold everywhere at once.
statistics-target-ecdf-away = { $count ->
    [one] { $count } standard far outside not drawn.
   *[other] { $count } standards far outside not drawn.
}
statistics-target-nothing = Nothing to draw: no height of this target is left by the filter.
statistics-height-x = height above the road ({ $unit })
statistics-target-density-title = { $target }, density
statistics-target-density-says = Density of corrected { $target } heights
statistics-target-density-note = Corrected heights, Gaussian kernel, pointwise 95 % band.
statistics-share = Share of { $target ->
    [driver_eye] drivers
    [taillight] taillights
   *[headlight] headlights
} below { $height } ({ $standard }): <strong>{ $share }</strong> <muted>({ $low } to { $high }; { NUMBER($below) } of { NUMBER($n) })</muted>
statistics-compared-title = { $second } beside { $first }
statistics-compared-figure = Figure
statistics-compared-mean = mean
statistics-compared-heights = Heights
statistics-compared-of = { NUMBER($first) } and { NUMBER($second) }
statistics-compared-difference = Difference
statistics-compared-interval = { $low } to { $high }
statistics-compared-verdict = Verdict
statistics-compared-higher = higher: more than noise
statistics-compared-lower = lower: more than noise
statistics-compared-alike = not told apart
statistics-compared-unknown = no interval: { $reason }
statistics-compared-none = No target has two heights or more in both surveys.
statistics-compared-note = Figures of true heights, the survey made later less the one made earlier, with total 95 % intervals. A figure is called higher or lower where its interval leaves 0 out. Errors are taken to be each survey’s own: where both share some, the intervals are too wide, never too narrow.
statistics-rule-title = The same rule today
statistics-rule-standard = Standard
statistics-rule-rule = Its rule
statistics-rule-of = P{ $percent } of { $class }
statistics-rule-all = all vehicles (no class is known)
statistics-rule-height = standard ({ $unit })
statistics-rule-today = today ({ $unit })
statistics-rule-interval = { $low } to { $high }
statistics-rule-difference = difference
statistics-rule-verdict = Verdict
statistics-rule-lower = lower; wrong with a probability of { $risk }
statistics-rule-higher = higher; wrong with a probability of { $risk }
statistics-rule-least = less than { $risk }
statistics-rule-alike = not told apart; lower with a probability of { $lower }
statistics-rule-unknown = no verdict: { $reason }
statistics-rule-note = The percentile that a standard is set by, of true heights today with its total 95 % interval. “Lower” and “higher” are said where the probability that it is not so is at most 2.5 % (JCGM 106).
statistics-percentiles = Percentiles, { $target }
statistics-percentiles-save = Percentiles as CSV
statistics-percentile = Percentile
statistics-percentiles-corrected = corrected ({ $unit })
statistics-percentiles-raw = as the paper ({ $unit })
statistics-percentiles-true = true heights ({ $unit })
statistics-percentiles-total = True heights: random error is taken out of the spread. Their 95 % intervals hold { $words }.
statistics-percentiles-note = The other 95 % intervals hold sampling alone.
statistics-percentiles-without = { $count ->
    [one] Why { $count } percentile has none
   *[other] Why { $count } percentiles have none
}
statistics-percentiles-reason = { $percentiles }: { $reason }.

## Statistics: heights by group

statistics-lateral-title = Lateral position
statistics-lateral-note = Distance of the tyre’s contact from the camera, measured across the road; one of each vehicle, the median of its contacts. A lane is all that goes one way in the picture.
statistics-lateral-figure = Lateral position by lane
statistics-lateral-says = Cumulative distributions of the distance from the camera across the road, of { $count } lanes.
statistics-lateral-x = distance from the camera across the road ({ $unit })
statistics-lateral-none = No vehicle has a direction yet, so there are no lanes; the search for passes fills it in, or the vehicle’s panel.
statistics-lateral-vehicles = vehicles
statistics-lateral-all = all
statistics-lane-right = to the right
statistics-lane-left = to the left
statistics-groups-title = Corrected heights by group
statistics-groups-target = Target
statistics-groups-by = Grouped by
statistics-grouping-category = Category
statistics-grouping-class_set = Set
statistics-grouping-lighting = Lighting
statistics-grouping-site = Site
statistics-grouping-operator = Operator
statistics-groups-head = { $grouping ->
    [category] category
    [class_set] set of classes
    [lighting] lighting
    [site] site
   *[operator] operator
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
    [one] { $count } group
   *[other] { $count } groups
}
statistics-groups-note = The { NUMBER($count) } largest groups of { NUMBER($all) }; the table lists more.
statistics-groups-nothing = { $grouping ->
    [category] Nothing to draw: no vehicle has a category.
    [class_set] Nothing to draw: no vehicle is of a set.
    [lighting] Nothing to draw: no vehicle has a lighting.
    [site] Nothing to draw: no vehicle has a site.
   *[operator] Nothing to draw: no vehicle has an operator.
}
statistics-groups-mean = mean ({ $unit })
statistics-groups-sd = SD ({ $unit })

## Statistics: standards

statistics-standards-title = Standards drawn in
statistics-standards-change = Change this survey’s standards
statistics-standards-one-survey = The table belongs to the survey and goes into its package.
statistics-standards-surveys = Each survey has a table of its own; choose one survey to change it.
statistics-standards-address = Ticks and own values are kept in this page’s address.
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
statistics-standard-cited = as cited by { $by }
statistics-standard-edition-field = Edition
statistics-standard-year = Year
statistics-standard-class = Class of the percentile
statistics-standard-cited-by = As cited by
statistics-standard-drawn-yes = yes
statistics-standard-drawn-no = no
statistics-standards-rule = rule
statistics-standards-drawn = drawn
statistics-standards-standard = standard
statistics-standards-for = for
statistics-standards-height = height
statistics-standards-source = source
statistics-standards-remove = remove
statistics-standard-draw = Draw { $standard }, { $what }, { $height }
statistics-standard-remove = Remove { $standard }
statistics-standard-own-problem = Give a height above 0 and below 10 m, such as { $example }.
statistics-standard-own = Own value for
statistics-standard-height = Height
statistics-standard-name = Standard
statistics-standard-for = For
statistics-standard-source = Source
statistics-standard-new = New standard
statistics-standard-new-remove = Remove the new standard
statistics-standard-problem = Give the height of { $standard }, such as { $example }.
statistics-standard-new-problem = Give the height of the new standard, such as { $example }.
statistics-standards-add = Add a standard
statistics-standards-save = Save for this survey

## Statistics: how many vehicles to measure

statistics-plan-title = How many vehicles to measure
statistics-plan-percentile = Percentile
statistics-plan-width = Width of its interval
statistics-plan-sd = Spread of heights (SD)
statistics-plan-incomplete = Give three numbers.

## Planning: the page

planning-lead-heights = What a height will be worth from here, before anything is filmed.
planning-lead-lines = What the speed of a vehicle will be worth with two line cameras, before anything is recorded.
planning-nothing-stored = Nothing on this page is stored; its address holds every value, so a link to it can be passed on.
planning-title-lines = Plan the line rate
planning-what = What is planned
planning-what-heights = Heights, by video
planning-what-lines = Speeds, by line scan
planning-loading-cameras = the cameras
planning-loading-rig = the survey's rig
planning-loading = the plan
planning-advice = Advice
planning-lens-exact = The lens is taken as exactly known.
planning-lens-exact-plain = The lens is taken as exactly known, and without distortion.
planning-lens-calibrated = A calibration adds its own uncertainty, most of it away from the board.
planning-roof = Roof
planning-driver_eye = Driver’s eye, near side
planning-driver_eye_far = Driver’s eye, far side
planning-taillight = Taillight
planning-headlight = Headlight

## Planning: what is planned with

planning-width = Picture width
planning-height = Picture height
planning-field-of-view = Horizontal field of view
planning-camera-height = Camera above road
planning-distance = To the wheel track
planning-board-distance = To the board
planning-board-distance-usual = wheel track
planning-direction = Turned along road
planning-sigma = Click sigma
planning-travel = Two-frame travel
planning-camera = Camera
planning-calibration = { $camera }: { $calibration }
planning-calibration-in-use = { $camera }: { $calibration } (in use)
planning-calibration-unknown = calibration { $id }
planning-camera-plain = A camera that is not calibrated yet
planning-number-problem = Give a number.
planning-speed = Fastest vehicle
planning-error = Speed off by
planning-baseline = Baseline
planning-u-baseline = Its u (k = 1)
planning-line-rate = Camera’s line rate
planning-line-rate-usual = what it takes

## Planning: the table of targets

planning-targets-title = What each target will be worth
planning-target = Target
planning-planned-height = planned height
planning-inset = inset
planning-two-frames = U95, two frames
planning-inset-ignored = error, inset ignored
planning-targets-note = Heights and insets are estimates; the survey’s own insets are used. Two frames: the vehicle has moved { $travel } between them, and the inset is solved for instead of assumed.
planning-parts-title = Contributions to u, one frame
planning-parts-label = Contributions to u
planning-parts-source = Source
planning-parts-sum = u, root of the sum of squares

## Planning: figures and drawings

planning-figure-distance-title = U95 of vehicles at other distances
planning-figure-distance-note = One frame; camera, board and pose as planned. A line ends where the picture ends.
planning-figure-distance-label = U95 of vehicles at other distances, U95 in { $small } over distance across the road to the wheel track in { $unit }
planning-figure-distance-x = distance across the road to the wheel track ({ $unit })
planning-figure-distance-y = U95 ({ $unit })
planning-figure-bias-title = Error of a driver’s eye whose inset is ignored
planning-figure-bias-note = It vanishes for a camera at the eye’s height.
planning-figure-bias-label = Error of a driver’s eye whose inset is ignored, error in { $small } over camera above the road in { $unit }
planning-figure-bias-x = camera above the road ({ $unit })
planning-figure-bias-y = error ({ $unit })
planning-figure-bar = The bar marks the planned place.
planning-along-title = The site, seen along the road
planning-along-note = To scale. The wedge is what the picture shows above and below; dots are the targets.
planning-along-label = Cross-section: camera { $camera_height } above the road, board at { $board_distance }, wheel track at { $distance }
planning-above-title = The site from above
planning-above-note = To scale. The picture shows { $shown } of the wheel track with road and a driver’s eye in it.
planning-above-label = From above: the camera looks across the road, square to it, a car in the lane
planning-above-label-turned = { $turned_deg ->
    [one] From above: the camera looks across the road, turned { $turned_deg } degree along the road, a car in the lane
   *[other] From above: the camera looks across the road, turned { $turned_deg } degrees along the road, a car in the lane
}
planning-wheel-track = wheel track { $distance }
planning-wheel-track-and-board = wheel track and board { $distance }
planning-board = board { $distance }

## Planning: the line rate

planning-speed-title = What a speed will be worth
planning-lines = At { $speed } a vehicle takes <strong>{ $lines } lines</strong> from camera 1 to camera 2 at { $line_rate_hz } lines a second, { $one_line } of road a line.
planning-one-line = One line more or less changes its speed by <strong>{ $speed }</strong>.
planning-speed-u = Read to whole lines its standard uncertainty is { $u_lines } from the lines and { $u_baseline } from the baseline: <strong>{ $speed }</strong> in 95 of 100 cases.
planning-forms-title = As printed and as corrected
planning-forms-label = Both forms of equation (2)
planning-forms-equation = equation (2)
planning-forms-printed = as printed: its right side
planning-forms-corrected = corrected: its middle term
planning-forms-error = error of the speed
planning-forms-says = what it says
planning-forms-says-printed = n + 2 lines are counted for n, divided by n + 2. The paper’s own 6600 Hz and 1.3 % come from it.
planning-forms-says-corrected = n + 2 lines are counted for n, divided by n as the middle term 2 s / (b f) is. A little more careful.
planning-forms-line-rate = line rate for { $error }
planning-forms-line-rate-value = { $line_rate_hz } Hz
planning-forms-error-at = error at { $line_rate_hz } Hz
planning-forms-error-value = { $error }, { $speed }
planning-forms-note = n = b f / s: the lines from camera 1 to camera 2, of the baseline b, the line rate f and the speed s.

## Survey: the overview

survey-loading = the survey
survey-demonstration = demonstration
survey-edit = Edit
members-open = Members
members-title = Members of the survey
members-lead = Members and administrators see this survey. For everybody else it does not exist.
members-lead-open = Everybody who signs in sees this survey, and acts in it by the role of their account. Members have the role that stands here.
members-open-to-all = Open to everybody who signs in
members-name = Name
members-role = Role here
members-role-of = Role of { $person } in this survey
members-remove = Take out
members-remove-title = Take { $person } out of the survey?
members-remove-body = { $person } no longer sees it. What they did stays theirs.
members-remove-yourself = You will no longer see this survey.
members-none = Nobody belongs to this survey yet; administrators manage it.
members-inactive = switched off
members-add = Add
members-add-person = Person
members-add-role = Role
members-choose = Choose a person
members-everybody = Everybody with an account is a member.
members-does-viewer = sees everything, exports packages
members-does-operator = brings in recordings, calibrates, measures
members-does-reviewer = what an operator does, and reviews the work of others
members-does-manager = what a reviewer does, and says who belongs to the survey and how it is reviewed
members-loading = Loading the members
survey-camera = Calibrate the camera
survey-recordings = Bring in the recordings
survey-pose = Find the road
survey-vehicles = Measure the vehicles
survey-review = Review the measurements
survey-results = Export the results
survey-camera-go = Calibrate
survey-recordings-go = Add recordings
survey-pose-go = Find the road
survey-vehicles-go = Measure
survey-review-go = Review
survey-results-go = Export
survey-open = Open
survey-statistics = <link>Statistics</link>: errors, distributions, percentiles.
survey-traffic = Traffic keeps { $traffic ->
    [right] right
   *[left] left
}, the steering wheel is usually on the { $steering ->
    [right] right
   *[left] left
}, the camera stands { $camera ->
    [verge] on the verge
   *[median] in the median
}.
survey-asked = Asked for: by day { $daytime }; in low light { $low_light }.
survey-traffic-unsaid = Nobody has said yet how traffic goes here and where the camera stands. Until then no driver’s eye has a height; those that are clicked get theirs when it is said.
survey-traffic-say = Say it
survey-scans-none = <link>Line scans</link>: { $summary }
survey-scans-label = Line scans, a way of their own beside these steps
survey-scans = Line scans
survey-scan-results = <link>Results</link>: speeds, gaps, lengths against the manufacturers’.
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
survey-count-measured = of { NUMBER($count) } measured
survey-count-measurements = { $count ->
    [one] measurement
   *[other] measurements
}

## Survey: editing it

survey-edit-title = Edit the survey
survey-name = Name
survey-name-problem = A survey needs a name.
survey-site = Site
survey-description = Description
survey-insets = Insets
survey-insets-help = How far each target lies behind the plane through the tyres’ outer faces, away from the camera. Used for every new measurement; the second figure is its standard uncertainty.
survey-insets-target = Target
survey-insets-inset = inset ({ $unit })
survey-insets-u = u ({ $unit })
survey-inset-label = { $target }: inset in { $unit ->
    [ft] feet
   *[m] metres
}
survey-inset-u-label = { $target }: uncertainty in { $unit ->
    [ft] feet
   *[m] metres
}
survey-inset-problem = { $target }: give the inset and its uncertainty as numbers in { $unit ->
    [ft] feet
   *[m] metres
}, for example { $inset } and { $u_inset }.

## Survey: photographs of the set-up

photographs-title = Photographs of the set-up
photographs-help = The rig, the road, the board in place. The report and the package show them.
photographs-choose = Choose photographs to add
photographs-drop = Drop photographs here, or choose them
photographs-adding = Adding { $count } …
photographs-hint = JPEG, PNG, WebP or TIFF. Kept at 1600 pixels a side at most, without the place where they were taken.
photographs-open = Open { $photograph }
photographs-what = What it shows
photographs-caption = Caption of { $photograph }
photographs-left = Move { $photograph } to the left
photographs-right = Move { $photograph } to the right
photographs-remove = Take out { $photograph }
photographs-removed = { $photograph } was taken out.

## Surveys: the page

surveys-lead = One survey is one campaign at one site: its camera, recordings, vehicles and people.
surveys-loading = surveys
surveys-new = New survey
surveys-new-make = Make the survey
surveys-new-name = Name
surveys-new-name-example = Rouen south, lane 1
surveys-new-name-problem = Give the survey a name, for example the road and the lane.
surveys-new-site = Site
surveys-new-site-example = D938, km 12.4, towards the south
surveys-new-description = Description
surveys-new-description-hint = What whoever opens it in five years should know.
surveys-choose-password = Choose a password
surveys-link-used = Your sign-in link is used up now; choose a password to be able to come back.
surveys-demo-failed = The demonstration survey could not be made.
surveys-demo-first = The demonstration survey is rendered from a known scene, so every height you measure in it can be compared with the truth. Try the work there first; then make a survey of your own.
surveys-demo-open = Open the demonstration survey
surveys-demo-title = Demonstration survey
surveys-demo-being-made = being made
surveys-demo-wait = Rendering a road, a checkerboard and some forty vehicles; this takes about a minute.
surveys-none-title = No surveys yet
surveys-none-make = Make a survey for a site, then calibrate its camera, drop in the day's video, and measure. The demonstration survey has all of that in it already.
surveys-none = Nobody has made a survey yet. An operator can make the first one.
studies-lead = Surveys of many sites and years joined: figures of the fleet with total uncertainty, and what they change.
studies-loading = Loading the studies ...
studies-new = New study
studies-new-make = Create study
study-not-chosen = No study is chosen
studies-none-title = No studies
studies-none = A study joins surveys of several sites, weights their vehicles to the fleet, and says how sure its percentiles are.
studies-name = Study
studies-surveys = Surveys
studies-sites = Sites
studies-heights = Heights
studies-computed = Computed
studies-not-computed = not computed
study-loading = Loading the study ...
study-simulated = simulated
study-simulated-note = Simulated: nothing here was filmed. The vehicles were drawn from known fleets, and no figure says anything of real roads.
study-name = Name
study-description = Description
study-report = Report (PDF)
study-package = Study package
study-compute = Compute
study-compute-again = Compute again
study-computed = The study is computed.
study-old-study = The study was changed since these figures were computed; compute them again.
study-old-surveys = Something was written since these figures were computed, in { $surveys }; compute them again to be sure.
study-empty-title = No surveys yet
study-empty = Add the surveys that the study joins; each has a site, and may have a stratum and a year.
study-add-surveys = Add surveys
study-not-computed-title = Not computed yet
study-not-computed = Compute the study to see its figures.
study-made = Computed { $moment } by { $person } with Sightline { $version }; SHA-256 of the package { $hash }.
study-made-by-system = the system
study-joined = Surveys
study-edit = Edit
study-edit-title = Edit study
study-remove = Remove study
study-remove-now = Remove
study-remove-words = { $name } goes from the list of studies. Its surveys stay as they are, and what was computed of it stays stored.
study-members = Who sees this study
study-members-note = Members see its figures, package and report, also of surveys that they do not belong to. Administrators see every study.
study-members-open = Everybody who signs in sees it
study-members-add = Add a member
study-members-choose = Choose a person
study-members-nobody = Everybody is a member
study-members-remove = Take { $name } out
study-survey = Survey
study-site = Site
study-stratum = Stratum
study-year = Year
study-counted = Heights that count
study-outside = Out of sample
study-weighted = Heights are weighted to the fleet that was given.
study-not-weighted = No fleet was given: vehicles count as they were drawn.
study-sites-known = Strata, numbers of sites and traffic follow the table of sites.
study-sites-unknown = No table of sites was given: each stratum is taken to have very many sites of equal traffic.
study-goal-is = The plan is for a U95 of { $goal } of P10.
study-fleet = Fleet (CSV)
study-fleet-hint = Columns category and share (or registrations); several kinds: variable, class, share. Empty: no weights.
study-sites = Sites (CSV)
study-sites-hint = Columns site and stratum; sites_there and traffic where known. Empty: strata as given with the surveys.
study-goal = U95 wanted of P10
study-goal-unit = mm
study-goal-hint = For the plan of a further study.
study-take-out = Take { $name } out
study-add-survey = Add a survey
study-choose-survey = Choose a survey
study-no-more-surveys = No other surveys
study-surveys-hint = Surveys of one site are one cluster. Years are compared where two or more are given.
study-choose-file = Choose file
study-choose-file-of = Choose file: { $table }
study-counted-words = { NUMBER($heights) } accepted heights of { NUMBER($vehicles) } vehicles at { $sites ->
    [one] { $sites } site
   *[other] { $sites } sites
}.
study-percentiles = Percentiles of true heights ({ $unit })
study-holds = Below each value its total 95 % interval: sampling of vehicles and sites, errors that heights share (road pose, mean inset), and random error, which is taken out of the values.
study-target = Target
study-n = n = { NUMBER($n) }
study-mean = mean
study-sd = SD
study-effects = Design effects
study-effects-note = The design effect is the variance by this design over that of as many vehicles drawn one by one; effective n is the number over it.
study-figure = Figure
study-vehicles = Vehicles
study-effect = Design effect
study-effective = Effective n
study-weighting = Of weights alone
study-years = Years compared
study-years-note = The later year less the first, each weighted by itself, with total 95 % intervals. Higher or lower is said where the interval leaves 0 out. Errors are taken to be each year’s own: where both share some, the intervals are too wide, never too narrow.
study-years-column = Years
study-years-of = { $first } to { $second }
study-errors = Error against makers’ heights
study-errors-note = Measured minus the maker’s height of roofs, not rounded, with 95 % intervals.
study-lighting = Lighting
study-bias = Bias
study-all = all
study-classes = Classes of vehicles
study-classes-note = Shares as drawn, with 95 % intervals, beside the fleet’s.
study-class = Class
study-share = Share
study-fleet-share = Fleet
study-plan = A further study: U95 of P10 within { $goal }
study-plan-note = Vehicles needed at each site, if sites and vehicles differ as these do.
study-plan-sites = Sites
study-plan-none = no number
study-curve-title = { $target }: true heights
study-curve-says = Cumulative distribution of true heights, { $target }, with its band.
study-curve-note = The band joins the total 95 % intervals of the percentiles. Dashed: random error left in.
study-curve-true = true heights
study-curve-raw = random error left in

surveys-card = <made>{ $recordings ->
    [one] { $recordings } recording
   *[other] { $recordings } recordings
} · { $day }</made>
surveys-card-with-site = { $site } · <made>{ $recordings ->
    [one] { $recordings } recording
   *[other] { $recordings } recordings
} · { $day }</made>
surveys-vehicles-measured = Vehicles measured
surveys-heights-reviewed = Heights reviewed
surveys-scans-reviewed = Scans reviewed
surveys-scans = Line scans: { $summary }
surveys-all-done = All steps done
surveys-tally = { NUMBER($done) } <muted>of { NUMBER($all) }</muted>

## Sign in: the page

signin-loading = your account
signin-link-title = Your sign-in link
signin-with-password = Sign in with a password
signin-email = E-mail
signin-password = Password
signin-submit = Sign in
signin-help = No password yet? Use the one-time link: the server prints it when it first starts, and an administrator makes one for each new person.

## Account: the page

account-name = Name
account-email = E-mail
account-role = Role
account-password-change = Change the password
account-password-choose = Choose a password
account-no-password = You have no password yet; without one you need a new link for each sign-in.
account-password-present = Present password
account-password-new = New password
account-password-hint = At least { NUMBER($least) } characters; a few words in a row are easy to keep in mind.
account-password-short = { $count ->
    [one] That has { $count } character; at least { NUMBER($least) } are needed.
   *[other] That has { $count } characters; at least { NUMBER($least) } are needed.
}
account-password-again = The same again
account-password-differs = The two are not the same; type the new password twice.
account-password-set = Set the password
account-password-is-set = Your password is set.

## People: the page

people-only-admin = Only an administrator can see and change accounts; ask one if you need another role.
people-lead = Who may do what. Nobody reviews their own work, whatever their role.
people-loading = people
people-add = Add a person
people-name = name
people-email = e-mail
people-role = role
people-state = state
people-last-seen = last sign-in
people-actions = actions
people-you = (you)
people-role-of = Role of { $person }
people-no-password = no password yet
people-never = never
people-new-link = New link
people-switch-off = Switch off
people-switch-on = Switch on
people-role-title = Make { $person } { $role }?
people-role-body = { $person } may then: { $does }
people-role-change = Change the role
people-switch-off-title = Switch off { $person }?
people-switch-off-body = They are signed out and cannot sign in again; what they measured and reviewed stays under their name.
people-does-viewer = sees everything, exports packages
people-does-operator = brings in recordings, calibrates, measures
people-does-reviewer = what an operator does, and reviews the work of others
people-does-admin = everything, and people

## People: adding one

people-add-action = Add
people-add-name = Name
people-add-name-problem = Give the person's name as it should appear beside their work.
people-add-email = E-mail
people-add-email-hint = They sign in with it. Sightline sends no mail: you pass on the link that comes next.
people-add-email-problem = Give an e-mail address, for example ada@example.org.
people-add-role = Role
people-link-title = Sign-in link for { $person }
people-link-help = Pass this on to { $person }. It works once, for seven days, and is shown only now.
people-link = Sign-in link
people-link-copy = Copy the link
people-link-copied = The link is on the clipboard.
people-link-done = Done

## Audit: the page

audit-title = Audit trail
audit-lead = One event per write, chained by hash: nothing here can be changed or removed without the chain showing it.
audit-loading = the audit trail
audit-survey = Survey
audit-survey-all = All
audit-what = What was changed
audit-what-all = Everything
audit-none-title = No events here
audit-none-filtered = Nothing matches these filters; widen them.
audit-none = Nothing has been written yet.
audit-events = Audit events
audit-number = no.
audit-when = when
audit-who = who
audit-did = did
audit-changes = changes
audit-hash = hash
audit-older = Show older events
audit-hash-after = { $hash }, after { $previous }
audit-hash-first = { $hash }, after nothing
audit-check = Check the chain
audit-whole-title = The chain is whole
audit-whole = { $count ->
    [one] { $count } event checked; the last hash is <code>{ $hash }</code>.
   *[other] { $count } events checked; the last hash is <code>{ $hash }</code>.
}
audit-broken-title = The chain is broken

## Audit: what was done, and to what

audit-action-calibrate = calibrated
audit-action-cancel = cancelled
audit-action-cancelled = stopped
audit-action-check_drift = looked for drift in
audit-action-choose = chose
audit-action-choose_calibration = chose the calibration of
audit-action-create = made
audit-action-decide_drift = decided on the drift of
audit-action-delete = took out
audit-action-detect = found the board in
audit-action-draw = drew
audit-action-done = finished
audit-action-failed = failed at
audit-action-finish = finished
audit-action-fix = fixed
audit-action-import = imported
audit-action-ingest = read in
audit-action-ingest_failed = could not read
audit-action-order = put in order
audit-action-propose = made
audit-action-read = read
audit-action-reading_failed = could not read
audit-action-release = put back
audit-action-requeue = put back
audit-action-request = asked for the figures of
audit-action-restart_ingest = began again to read
audit-action-restart_reading = began again to read
audit-action-restore = brought back
audit-action-retire = retire
audit-action-review = judged
audit-action-revise = changed
audit-action-run = ran
audit-action-seal = sealed
audit-action-set_password = set the password of
audit-action-sign = signed
audit-action-take = took
audit-action-sign_out = signed out
audit-action-swap_cameras = exchanged the cameras of
audit-action-take_back_drift_decision = took back the decision on the drift of
audit-action-update = changed
audit-action-use = used
audit-action-compute_again = computed again
audit-action-undo = put back
audit-action-accepted = accepted
audit-action-full_inspection = sent to full inspection
audit-action-dissolved = dissolved
audit-action-taken_back = took back
audit-action-withdraw = withdrew
audit-entity-survey = survey
audit-entity-survey_member = member
audit-entity-camera = camera
audit-entity-calibration_image = calibration image
audit-entity-calibration = calibration
audit-entity-recording = recording
audit-entity-upload = upload
audit-entity-pose = pose
audit-entity-photograph = photograph
audit-entity-catalogue = catalogue
audit-entity-vehicle = vehicle
audit-entity-measurement = measurement
audit-entity-proposals = proposals of what to click
audit-entity-review = verdict
audit-entity-computing = heights computed again
audit-entity-review_plan = review plan
audit-entity-wheel_pair = wheel pair
audit-entity-click_sigma = click sigma
audit-entity-standards = standards
audit-entity-scan = scan
audit-entity-scan_run = scan run
audit-entity-lot = lot
audit-entity-lot_decision = decision on a lot
audit-entity-scan_vehicle = scan vehicle
audit-entity-scan_measurement = scan measurement
audit-entity-scan_review = scan review
audit-entity-line_pose = line pose
audit-entity-line_height = line height
audit-entity-line_height_review = line height review
audit-entity-export = export
audit-entity-study = study
audit-entity-study_result = result of a study
audit-entity-study_member = member of a study
audit-entity-package = package
audit-entity-checkpoint = checkpoint
audit-entity-signing_key = signing key
audit-entity-person = person
audit-entity-sign_in_link = sign in link
audit-entity-job = job
audit-subject-vehicle = vehicle { $vehicle }
audit-subject-target = vehicle { $vehicle }, { $target ->
    [roof] roof
    [driver_eye] driver's eye
    [taillight] taillight
    [headlight] headlight
   *[other] other
}
audit-subject-verdict = { $verdict }: { $subject }
audit-subject-named = { $entity } “{ $name }”
audit-person = Person
audit-person-all = Everybody
audit-day = Day (UTC)
audit-vehicle = Vehicle’s number
audit-vehicle-problem = A vehicle’s number is a whole number.
audit-row = row { $id } of the database

## Export: the page

export-lead = A zip file with everything needed to check each height, and to compute it again.
export-crops = with pictures of the clicks
export-of-title = Vehicles in statistics and report
export-of-lighting = Lighting
export-of-filmed-from = filmed from { $day }
export-of-filmed-to = filmed up to { $day }
export-of-help = Statistics, figures and report are of these vehicles, and the report’s first page says so. The tables are whole, so that the audit trail can vouch for them; exclusions.csv names what is left out.
export-of = of
export-of-all = all vehicles
export-build = Build the package
export-ready = The package is ready.
export-failed = The package could not be built; try again.
export-open-to-review = { $to_review ->
    [one] { $to_review } measurement not yet reviewed.
   *[other] { $to_review } measurements not yet reviewed.
}
export-open-rejected = { $rejected ->
    [one] { $rejected } measurement rejected and not clicked again.
   *[other] { $rejected } measurements rejected and not clicked again.
}
export-open-both = { $to_review ->
    [one] { $to_review } measurement not yet reviewed
   *[other] { $to_review } measurements not yet reviewed
}, { $rejected ->
    [one] { $rejected } measurement rejected and not clicked again.
   *[other] { $rejected } measurements rejected and not clicked again.
}
export-open-note = The package says so, row by row; <link>review first</link> if it is to be final.
export-packages = Packages
export-loading = packages
export-none-title = No package yet
export-none = Press “Build the package”. It takes from seconds to minutes, with the number of pictures, and you can go on working meanwhile.
export-made = made
export-by = by
export-size = size
export-sha256 = SHA-256
export-audit-head = head of the audit chain
export-download-column = download
export-download = Download
export-sha256-copy = Copy the SHA-256
export-sha256-copied = The SHA-256 is on the clipboard.
export-audit-head-copy = Copy the head of the audit chain
export-audit-head-copied = The head of the audit chain is on the clipboard.
export-checking = Checking a package
export-checking-help = This checks every file, the audit chain, its signature and each row against it, and computes every height and every statistic again. Send this installation's key (or the SHA-256) by another way than the package: it finds a package that somebody wrote anew and signed with another key. A signature proves what the holder of the key signed, not that it is true.
export-command-copy = Copy the command
export-command-copied = The command is on the clipboard.

## Export: what is in a package

export-contents = What is in a package
export-contents-report = a few pages for people: set-up, calibration, method, errors, figures, exclusions
export-contents-measurements = each measurement as it stands: vehicle, target, frame, height and its uncertainty
export-contents-exclusions = what counts for no result, and why
export-contents-statistics = error table, percentiles, distributions and corrections as CSV; figures as SVG
export-contents-crops = the picture that each click was made on, unmarked, and with its points beside it
export-contents-revisions = every revision with its clicks, and where its uncertainty comes from
export-contents-clicks = the clicks alone: “sightline height” computes the same heights from them
export-contents-vehicles = make, model, year, manufacturer’s height and its source, lighting
export-contents-recordings = file hashes, and the time stamp and checksum of each frame measured on
export-contents-poses = where the camera stood and what its lens does, as tables and as JSON
export-contents-classes = classes of vehicles with their sets; the vehicles that statistics and report are of
export-contents-insets = insets in force; both tyres of a vehicle, for its direction of travel
export-contents-reviews = who accepted, fixed or rejected what, and why; what was clicked again
export-contents-audit = each change with its hash; the chain can be checked
export-contents-datapackage = name, unit and meaning of every column (Frictionless Data)

## Proposals: why a point of a passing vehicle is not proposed (kept by key)

proposals-not-across = The vehicle goes down or up the picture; contacts and heights want one that goes across.
proposals-no-empty-road = There are too few frames before and after the vehicle to tell the empty road.
proposals-rear-not-in-view = The vehicle’s rear end is not in view.
proposals-not-one-vehicle = The wheels found on several frames do not belong to one vehicle.
proposals-headlight-by-hand = The middle of a headlight is not found well enough yet; click it yourself.
proposals-eye-by-hand = A driver’s eye behind glass is not found well enough yet; click it yourself.
proposals-wheels-on-few-frames = Wheels stand out from shadow and body on too few frames.
proposals-halves-disagree = Two halves of the frames do not agree on it.
proposals-roof-from-above = The camera looks down on this roof, so its near edge is no outline; click it yourself.
proposals-wheel-on-best-frame = This wheel does not stand out from shadow and body on the best frame.
proposals-not-in-picture = It is not in the picture on the frame that shows most.
proposals-roof-not-one-line = The roof’s edge is not one line here.
proposals-vehicle-not-distinct = The vehicle does not stand out from what is behind it.
proposals-roof-not-in-picture = The roof is not in the picture on these frames.
proposals-roof-not-distinct = The roof does not stand out from what is behind it.
proposals-rear-not-in-picture = The vehicle’s rear end is not in the picture on these frames.
proposals-no-red = No lamp stands out in red at the rear end.
proposals-red-not-a-lamp = What is red at the rear end has not the size of a lamp.
proposals-lamp-small = The rear lamp is too small here.
proposals-lamp-edge = The lower edge of the rear lamp does not stand out.
proposals-no-wheel = No wheel stands out from shadow and body on these frames.
proposals-no-height = No height follows from this point; click it yourself.


## Proposals: the job, and what is refused

proposals-looking = Looking for what to propose.
proposals-made = { $some } of { $passes ->
    [one] 1 pass has
   *[other] { $passes } passes have
  } proposals, { $points ->
    [one] 1 point
   *[other] { $points } points
  } in all.
proposals-cancelled = The work on proposals was cancelled; what was proposed before stays. Start it again when you like.
proposals-being-made-already = Proposals for { $name } are being made already; wait for that.
proposals-no-found-passes = { $name } has no passes that were found by Sightline; let the passes be found first.
measurements-proposals-not-these = These are not the points that are proposed on this frame now: the proposals were made again. Look at them and confirm again.


## Errors: cameras

cameras-charuco-board-needs-dictionary-markers-side = A ChArUco board needs the dictionary of its markers, the side of a marker and the side of a square; give all three.
cameras-plain-checkerboard-no-markers-choose-charuco = A plain checkerboard has no markers; choose ChArUco as the kind of board, or leave out dictionary and marker.
cameras-frames-not-recording-frames-0 = Frames { $first } to { $last } are not in the recording; it has frames 0 to { $frame_count }.
cameras-every-th-frame-would-views-take = Every { $every }th frame would be { $count } views; take every { $least }th or fewer frames.
cameras-too-large-calibration-file-choose-file = { $file_name } is too large for a calibration file; choose the file that holds the intrinsics.
cameras-not-text-file-choose-calibration-yaml = { $file_name } is not a text file; choose a calibration as YAML, JSON or cameramodel.
cameras-not-file-give-picture-files-clip = { $path } is not a file; give picture files or a clip.
cameras-choose-calibration-give-pictures-width-height = Choose a calibration, or give the picture's width and height in pixels and its horizontal field of view in degrees.
cameras-calibration-belongs-another-survey-choose-one = Calibration { $calibration_id } belongs to another survey; choose one of this survey's cameras.
cameras-cameras-csv-not-what-audit = cameras.csv: camera { $id } is not what its audit events made of it; the table was changed.
cameras-calibration-of-another-camera = calibrations.csv: { $id } names its camera otherwise than the audit events; the table was changed.
cameras-taken-without-calibration = The camera { $camera } has no calibration yet, so there is nothing to take over; calibrate it in its own survey, or add it here as a new camera.
cameras-taken-from-itself = The camera { $camera } is this survey’s own; choose one of another survey.
cameras-camera-needs-name-fill = A camera needs a name; fill it in.
cameras-calibration-belongs-another-camera-choose-one = Calibration { $calibration_id } belongs to another camera; choose one of this camera's.
cameras-image-without-board-needs-reason-why = An image without a board needs the reason why; say what was looked for.

## Errors: commands

commands-empty-give = { $path } is empty; give { $what }.
commands-no-column-give = { $path } has no column { $missing }; give { $what }{ $hint }.
commands-column-more-once-name-each-column = { $path } has the column { $twice } more than once; name each column once.
commands-not-readable-csv-table-give = { $path } is not a readable CSV table ({ $problem }); give { $what }.
commands-not-percentile = “{ $part }” is no percentile; give numbers between 0 and 100, such as --percentile 2.5,10,50.
commands-not-csv = { $path } cannot be read as a table ({ $why }); give { $what }.
commands-no-row-with-height = { $path } has no row with a height; give one with rows whose status is ok.
commands-distribution-needs-column = { $path } has no column { $name }; give a heights.csv that has it.
commands-row-not-length = { $where }: { $name } “{ $cell }” is no length in metres that can be; correct the cell.
commands-no-column-give-heights-csv-made = { $path } has no column { $missing }; give a heights.csv made from clicks with reference_height_m.
commands-cannot-read-csv-text-give-heights = { $path } cannot be read as CSV text; give a heights.csv of sightline height.
commands-larger-200-mb-give = { $path } is larger than 200 MB; give { $what }.
commands-not-exist-give = { $path } does not exist; give { $what }.
commands-not-utf-8-text-give-saved = { $path } is not UTF-8 text; give { $what }, saved as UTF-8.
commands-cannot-read-give = { $path } cannot be read ({ $strerror }); give { $what }.
commands-not-readable-json-give = { $path } is not readable JSON; give { $what }.
commands-cannot-written-choose-another-place = { $path } cannot be written ({ $strerror }); choose another place.
commands-stream-empty = Standard input ended before one pair of lines ({ $pair_bytes } bytes) had come; start the cameras first, and check --rows.
commands-cannot-written-because-disk-full-free = { $path } cannot be written because the disk is full; free some space.
commands-charuco-marker-go-together-give-dictionary = --charuco and --marker go together; give the dictionary and the marker's side.
commands-board-not-form-9x6-count-inner = --board { $text } is not of the form 9x6; count the inner corners across and down.
commands-size-not-form-1920x1080-give-width = --size { $text } is not of the form 1920x1080; give width and height in pixels.
commands-give-contact-x-y-target-x = Give --contact X,Y and --target X,Y, or --clicks with a CSV file.
commands-sigma-inset-u-inset-must-finite = --sigma, --inset and --u-inset must be finite numbers, --sigma and --u-inset not negative; correct them.
commands-give-o-heights-csv-write = Give -o with the heights.csv to write.
commands-not-form-x-y-give-two = { $option } { $text } is not of the form X,Y; give two numbers of pixels.
commands-problem = { $names }: { $message }
commands-give-either-contact-target-clicks-not = Give either --contact and --target or --clicks, not both.
commands-no-effect-here-use-instead = --{ $name } has no effect here; use { $instead } instead.
commands-cannot-written-folder-not-exist-choose = { $output } cannot be written, its folder does not exist; choose another place.
commands-given-twice-give-strips-both-cameras = { $first } is given twice; give the strips of both cameras.
backup-none-here = { $folder } holds no whole backup (no manifest.json); run sightline backup into it again, or name another folder.
backup-other-format = { $folder } holds a backup of another format; use the version of Sightline that made it.
backup-manifest-damaged = { $path } is not what the backup wrote; use another backup.
backup-file-missing = { $name } is missing from the backup; use another backup, or run sightline backup into it again.
backup-file-changed = { $name } of the backup is not the file that was backed up; use another backup.
backup-folder-holds-other-things = { $folder } holds other things than a backup; choose an empty folder or an earlier backup.
backup-folder-in-data-folder = { $folder } and the data folder hold each other; choose a folder elsewhere, on another disk at best.
backup-under-way = Another backup is being written to { $folder }; wait until it ends.
backup-database-not-copied = The database { $path } could not be copied ({ $said }); try again.
backup-of-another-installation = The folder holds a backup of another installation, or of a later state than this; choose another folder.
backup-other-tables = The backup has a table { $name } that this version does not know; restore it with the version that made it.
backup-rows-do-not-fit = The rows of { $name } in the backup do not fit their table; use another backup.
backup-other-kind-of-database = The backup is of a { $kind } database and is restored into that kind only; set SIGHTLINE_DATABASE_URL accordingly.
backup-place-not-empty = { $place } is not empty; restore into a new or empty place.
backup-database-not-empty = The PostgreSQL database already has tables; restore into an empty one.
backup-chains-end-elsewhere = The audit chains in the backup's database do not end where its manifest says; use another backup.
backup-chain-broken = The database in the backup does not verify: { $problem }
backup-media-missing = { $count ->
    [one] The backup is whole, but a media file that the database names is not in the media store: { $names }
   *[other] The backup is whole, but { $count } media files that the database names are not in the media store, such as { $names }
 }; look for it in an earlier backup.

commands-no-database-name-folder-data-dir = There is no database at { $path }; name its folder with --data-dir.
commands-cannot-used-correct = { $name } cannot be used ({ $said }{ $said_2 }); correct it.
commands-give-either-camera-size-field-view = Give either --camera, or --size and --field-of-view.
commands-speed-speed-error-line-rate-u = --speed, --speed-error, --line-rate and --u-baseline need --baseline.
commands-give-camera-height-distance-baseline-line = Give --camera-height and --distance; or --baseline for a line scan.
commands-line-scans-plan-needs-speed-speed = A line scan's plan needs --speed and --speed-error beside --baseline.
commands-numbers-plan-must-finite = The numbers of a plan must be finite.
commands-line-scan-planned-without-camera-place = A line scan is planned without a camera and its place; leave those options out.
commands-metrics-port-cannot-be-used = Metrics cannot be shown on port { $port } of { $host } ({ $why }); choose another with SIGHTLINE_METRICS_PORT.
commands-another-server-has-folder = Another server works with the folder { $folder }; stop it, or give this one a folder of its own with --data-dir.
commands-folder-cannot-written = Nothing can be written to the folder { $folder } ({ $why }); check its permissions and the disk, or name another with --data-dir.
commands-port-cannot-used-choose-another-port = Port { $port } on { $host } cannot be used ({ $why }); choose another with --port.
commands-option-not-negative = { $option } must be a finite number, not negative; correct it.
commands-row-without-pass = { $path }, row { $row }: the cell pass is empty; name the pass of every point.
commands-row-cells = { $path }, row { $row } has { $cells } cells, the header has { $columns }; correct the row.
commands-problem-2 = { $place }: { $problem }
commands-distance-or-speed = Give either --distance or --speed, not both.
commands-grade-difference-needs-distance = --grade-difference needs a sight distance; give --distance or --speed too.
commands-not-exist-name-database-data-folder = { $place } does not exist; name a database, a data folder or an exported folder.

## Errors: demo

demo-drawing-demonstration-stopped-middle-start-server = Drawing the demonstration stopped in the middle; start the server again.

## Errors: export

export-crop-could-not-encoded-export-survey = A crop could not be encoded; export the survey again.
export-frame-stored-video-not-one-clicked = Frame { $frame } of the stored video is not the one that was clicked on.
export-not-follow-these-statistics-put = { $strange } does not follow from these statistics; it was put in.
export-no-row-crops-csv-put = { $there } is in no row of crops.csv; it was put in.
export-crops-csv-other-points-frames-measurement = crops.csv: { $path } has other points or frames than its measurement; one is wrong.
export-not-one-whose-hash-crops-csv = { $path } is not the one whose hash crops.csv holds; it was exchanged.
export-no-picture-size-crops-csv-tells = { $path } is no picture of the size that crops.csv tells; it was exchanged.
export-not-show-points-measurement-changed = { $overlay } does not show the points of its measurement; it was changed.
export-cannot-read-take-whole-export-again = { $description } cannot be read; take the whole export again.
export-another-files-chain-changed = { $description } has another { $name } than the files and the chain; it was changed.
export-describes-otherwise-program-changed = { $description } describes { $named } otherwise than this program; it was changed.
export-too-rows-changed = { $path } has too { $value } rows; it was changed.
export-not-one-these-rows-statistics-give = { $path } is not the one that these rows and statistics give; it was replaced.
export-line-says-rows-give-one-wrong = { $path }, line { $at }: { $name } says { $told }, the rows give { $found }; one is wrong.
export-missing-named-twice-crops-csv-take = { $path } is missing or named twice in crops.csv; take the whole export again.
export-first-characters-head-prove-little-give = The first { $count } characters of a head prove little; give at least { $least_of_head }.
export-audit-csv-ends-not-head-kept = audit.csv ends with { $head }, not with the head that was kept: it was written anew, or this is another export.
export-no-no-whole-export-export-survey = There is no { $checksums }, so this is no whole export; export the survey again.
export-not-belong-export-take-out-check = { $strange } does not belong to the export; take it out and check again.
export-changed-after-export-take-whole-export = { $path } was changed after the export; take the whole export again.
export-checkpoint-form = checkpoint.json is not written as this program writes it; take the whole export again.
export-checkpoint-signature = checkpoint.json carries another signature than its key gives; it was changed.
export-checkpoint-other-chain = checkpoint.json does not vouch for the end of audit.csv; one was changed.
export-checkpoint-keys = checkpoint.json does not tell how its key followed from the ones before; it was changed.
export-checkpoint-other-key = The package was signed with key { $key } and not with the key that was given; it is another installation's or forged.
export-key-too-short = The first characters of a key prove little; give { $least } or more.
export-no-seal = audit.csv does not end with the event that seals the package: it was cut off or changed; take the whole export again.
export-page-not-described = { $path } is not described by datapackage.json, or missing although it is; take the whole export again.
export-page-another-program = { $path } is not the page that datapackage.json names; take the whole export again.
export-page-carries-another = The page carries another { $path } than the package; take the whole export again.
export-not-the-file-that-the-seal-names = { $path } is not what the package's seal, the last event of audit.csv, says: it was changed, taken out or put in after the export, and the sums with it.
export-event-of-another-survey-or-time = audit.csv: event { $number } is told or withheld where the package's seal says otherwise, or the chain does not begin with the survey; audit.csv was changed after the export.

## Errors: geometry

geometry-board-x-inner-corners-cannot-used = A board of { $columns }x{ $rows } inner corners cannot be used; count the inner corners (where four squares meet), 3 to 60 in each direction.
geometry-square-m-cannot-right-give-side = A square of { $square_m } m cannot be right; give the side of one square in metres.
geometry-model-could-not-fitted-these-views = The { $model } model could not be fitted to these views; add views from different sides or use the other model.
geometry-x-px-camera-calibrated-x-px = { $what } is { $width_px }x{ $height_px } px but the camera was calibrated at { $width_px_2 }x{ $height_px_2 } px; use a calibration made at the recording's size.
geometry-no-dictionary-markers-one-maker-board = { $dictionary } is no dictionary of markers; it is one of { $dictionaries }, as the maker of the board states.
geometry-markers-m-not-go-squares-m = Markers of { $marker_m } m do not go with squares of { $square_m } m; give the side of the black marker, which is smaller than its square.
geometry-board-x-inner-corners-markers-holds = A board of { $columns }x{ $rows } inner corners has { $needed } markers and { $dictionary } holds { $held }; choose the dictionary that the board was made with.
adjustment-nothing-uncertain = the pose states no uncertainty of its own and none of a board, so the traffic could change nothing; make it with sightline pose.
adjustment-contradictory = { $out } of { $passes } passes contradict the rest; check the known lengths, their uncertainties and which points were followed.
adjustment-does-not-settle = the passes do not settle on one pose; check that each point follows the same place of its vehicle.
geometry-must-correct-key-make-file-again = { $what }: '{ $key }' must be { $wanted }; correct that key or make the file again.
geometry-must-json-object-write-sightline-see = { $what } must be a JSON object; write it with sightline or see docs/formats.md.
geometry-distortion-model-not-supported-plumb-bob = { $file_name }: the distortion model '{ $word }' is not supported; plumb_bob, rational_polynomial, radtan, equidistant and fisheye are.
geometry-holds-no-camera-give-opencv-yaml = { $file_name } holds no camera; give OpenCV YAML or JSON, ROS camera_info, a Kalibr camchain or a mrcal .cameramodel.
geometry-holds-values-not-finite-calibrate-again = { $file_name }: { $what } holds values that are not finite; calibrate again.
geometry-image-size-must-two-whole-numbers = { $file_name }: the image size must be two whole numbers of pixels.
geometry-holds-no-camera-matrix-camera-matrix = { $file_name } holds no camera matrix (camera_matrix or K); export the intrinsics with their distortion coefficients.
geometry-camera-matrix-must-3x3-0-0 = { $file_name }: the camera matrix must be 3x3 with 0 0 1 as its last row.
geometry-camera-matrix-skew-which-not-supported = { $file_name }: the camera matrix has a skew, which is not supported; calibrate without.
geometry-holds-no-camera-holds = { $file_name } holds no camera '{ $which }'; it holds { $cameras }.
geometry-camera-model-not-supported-calibrate-pinhole = { $file_name }: the camera model '{ $camera_model }' is not supported; calibrate as pinhole.
geometry-intrinsics-must-four-numbers-fu-fv = { $file_name }: intrinsics must be four numbers, fu fv pu pv.
geometry-lens-model-not-supported-convert-mrcal = { $file_name }: the lens model { $word } is not supported; convert it with mrcal-convert-lensmodel to LENSMODEL_OPENCV8.
geometry-needs-intrinsics-file = { $file_name }: { $word } needs { $value } intrinsics, the file has { $count }.
geometry-not-say-how-large-pictures-add = { $file_name } does not say how large the pictures are; add image_width and image_height to it.
geometry-focal-lengths-must-positive-numbers-pixels = { $file_name }: the focal lengths must be positive numbers of pixels.
geometry-principal-point-lies-far-outside-picture = { $file_name }: the principal point lies far outside the picture; correct the image size.
geometry-thin-prism-tilt-coefficients-not-supported = { $file_name }: thin-prism and tilt coefficients are not supported; calibrate with at most eight.
geometry-distortion-coefficients-4-5-8-supported = { $file_name }: { $count } distortion coefficients; 4, 5 or 8 are supported.
geometry-no-readable-camera-file-give-opencv = { $file_name } is no readable camera file; give OpenCV YAML or JSON, ROS camera_info, a Kalibr camchain or a mrcal .cameramodel.
geometry-not-list-numbers-export-file-again = { $file_name }: { $what } is not a list of numbers; export the file again.
geometry-image-size-must-two-numbers-width = { $file_name }: the image size must be two numbers, width and height.
geometry-give-camera-info-unbinned-pictures = { $file_name }: { $key } is { $data }; give the camera_info of unbinned pictures.
geometry-fisheye-model-needs-four-coefficients-file = { $file_name }: a fisheye model needs four coefficients, the file has { $count }.
geometry-board-found-none-frames = The board was found in none of the { $count } frames. { $reason }
geometry-no-pose-fits-corners-check-camera = No pose fits the corners; check that the camera file belongs to this recording and that the whole board lies within the lens's valid radius.
geometry-reference-height-boards-uncertainties-must-numbers = The reference height and the board's uncertainties must be numbers, in metres and radians, the uncertainties not negative.
geometry-reference-row-m-above-road-cannot = A reference row { $height_m } m above the road cannot be right; give the height of the { $side } row of inner corners above the road in metres.
geometry-board-camera-moves-during-these-frames = The board or the camera moves during these frames (by up to { NUMBER($moved_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px); pick a span, or a single frame, in which both stand still.
geometry-corners-not-fit-camera-model-residual = The corners do not fit the camera model (residual { NUMBER($rms, minimumFractionDigits: 1, maximumFractionDigits: 1) } px); the camera file belongs to another camera or zoom, or the board is bent.
geometry-board-seen-edge-turn-towards-camera = The board is seen edge-on; turn it towards the camera, at least 10 degrees.
geometry-board-lies-on-road = The board seems to lie on the road; stand it up at right angles to the road, its rows level, or measure the height of the row of corners that you named.
geometry-reference-height-m-puts-camera-below = The reference height of { $height_m } m puts the camera below the road; give the height of the { $side } row of inner corners above the road, in metres.
geometry-picture-x-px-cannot-planned-give = A picture of { $width_px } x { $height_px } px cannot be planned with; give a width and a height from 16 to 16384.
geometry-horizontal-field-view-degrees-cannot-planned = A horizontal field of view of { $degrees } degrees cannot be planned with; give one from 5 to 150.
geometry-cannot-planned-give-one = A { $what } of { $value } { $unit } cannot be planned with; give one from { $least } to { $most }.

## Errors: audit

audit-signing-key-unreadable = { $path } holds no signing key (64 hexadecimal digits); put it back from a backup.
audit-signing-key-another = This machine's signing key is not the one that the database was signed with; put signing.key back from a backup, or give all machines the same SIGHTLINE_SIGNING_KEY.
audit-database-made-another-version-verify-one = This database was made by another version; verify it with that one, or open it once with this one (`sightline serve`), which brings it up to date.
audit-not-sightline-database-name-sightline-db = { $name } is not a Sightline database; name the sightline.db of a data folder.

## Errors: csv_package

csv_package-audit-csv-event-not-follow-one = audit.csv: event { $number } does not follow from the one before; it was changed.
csv_package-audit-csv-event-not-one-hashed = audit.csv: event { $number } is not the one that was hashed; it was changed.
csv_package-missing-take-whole-export-again = { $path } is missing; take the whole export again.
csv_package-file-name-folder-export-not-exist = { $target } is a file; name a folder for the export that does not exist yet.
csv_package-holds-other-files-name-folder-empty = { $target } holds other files; name a folder that is empty or does not exist yet.
csv_package-holds-file-twice-no-export-take = { $place } holds a file twice, so it is no export; take the export again.
csv_package-cannot-read-export-name-folder-zip = { $place } cannot be read as an export; name its folder or ZIP.
csv_package-parquet-and-csv-not-pairs = { $path } stands without its other form: every table of a package is there as CSV and as Parquet; take the whole export again.
csv_package-parquet-described-otherwise = { $path } has other columns, units or meanings than datapackage.json describes; it was changed.
csv_package-parquet-not-csv = { $path } is not what { $csv_path } holds: column { $name } differs at row { $at }; one was changed.
csv_package-parquet-other-rows = { $path } does not have the rows of { $csv_path }; one was changed.
csv_package-parquet-cannot-be-read = { $path } cannot be read as Parquet; take the whole export again.
csv_package-cell-not-of-its-type = { $path } has a cell that is not of the type that datapackage.json gives its column; it was changed.
csv_package-csv-of-another-form = { $path } is not written as Sightline writes a table (near line { $at }: another end of line, another quote): programs might read different things in it; take the whole export again.
csv_package-zip-odd-entry = { $place } holds { $path }, which is no plain file of a package; take the whole export again.
csv_package-zip-bomb = { $place }: { $path } would unpack to far more than any table holds; take the whole export again.
csv_package-too-many-files = { $place } lists more files than a package can have; take the whole export again.
csv_package-link = { $path } is a link, not a file (or a pipe or device): an export has none; take the whole export again.
csv_package-json-of-another-form = { $path } is not written as Sightline writes JSON (a key twice, other blanks or numbers): programs might read different things in it; take the whole export again.
csv_package-other-columns-than-described = { $path } has other columns than datapackage.json describes ({ $column }): it was changed after the export.
csv_package-cannot-read-csv-take-whole-export = { $path } cannot be read as CSV; take the whole export again.
csv_package-cannot-unpacked-take-whole-export-again = { $path } cannot be unpacked; take the whole export again.
csv_package-cannot-read-described-take-whole-export = { $path } cannot be read as it was described; take the whole export again.
csv_package-row-too-long-too-short-changed = { $path } has a row that is too long or too short; it was changed.
csv_package-without-audit-event-missing = { $path }: { $kind_name } { $odd } is there without its audit event, or is missing.
csv_package-twice-one-put = { $path }: { $columns } { $values } is there twice; one was put in.
csv_package-not-what-audit-event-says-changed = { $path } is not what its audit event says; it was changed.
csv_package-not-one-audit-chain-vouches-changed = { $path_of } is not the one that the audit chain vouches for; it was changed.
csv_package-made-others-another-time-says = { $path }: { $kind_name } { $id } was made by others or at another time than { $path_2 } says.
csv_package-differs-one-changed = { $path }: { $kind_name } { $id } differs from { $path_2 }; one was changed.
csv_package-not-csv-row-taken-out-changed = { $path }: { $mine } { $values } is not in { $table }.csv; a row was taken out or changed.

## Errors: database

database-database-not-supported-use-sqlite-file = A { $backend } database is not supported; use sqlite:///FILE or postgresql+psycopg://USER@HOST/NAME.
database-database-not-answer-check-runs-address = The database does not answer; check that it runs and that its address is right.
database-memory-database-would-lost-name-file = An in-memory database would be lost; name a file, as in sqlite:///sightline.db.
database-disk-full-nothing-saved-make-room = The disk is full, so nothing was saved; make room and try again.
database-database-busy-another-writer-try-again = The database is busy with another writer; try again in a moment.
database-database-file-cannot-opened-writing-check = The database file cannot be opened for writing; check the folder's permissions.
database-database-address-cannot-read-use-sqlite = The database address cannot be read; use sqlite:///FILE or postgresql+psycopg://.
database-no-database-check-name = There is no database { $path }; check its name.
database-file-not-database-program-give-right = This file is not a database of this program; give the right one.
database-no-migrations-set-sightline-migrations-folder = There are no migrations in { $folder }; set SIGHTLINE_MIGRATIONS to the folder that has them.
database-database-made-newer-version-update-one = The database was made by a newer version; update this one before opening it.
database-no-may-been-removed-go-back = There is no { $word }{ $number }; it may have been removed, so go back and choose another.

## Errors: jobs

jobs-somebody-else-started-job-ask-them = Somebody else started this job; ask them or an operator to cancel it.
jobs-worker-knows-no-job-kind-start = This worker knows no job of kind { $kind_name }; start one of this version.
jobs-job-went-another-worker-one-stops = Job { $id } went to another worker; this one stops.
jobs-job-already-nothing-cancel = Job { $job_id } is { $state } already, so there is nothing to cancel.
jobs-job-moved-meanwhile-nothing = Job { $id } moved on meanwhile; nothing to do.
jobs-job-given-another-worker-one-stops = Job { $id } was given to another worker; this one stops.

## Errors: web

web-server-busy = The server has more to do than it can at the moment; nothing was done, try again in a few seconds.
web-you-not-signed-sign-try-again = You are not signed in; sign in and try again.
members-last-manager = A survey keeps one manager; make somebody else its manager first.
audit-problem-ask-admin = The audit trail does not hold; ask an administrator to check it.
web-needs-role-you-ask-admin = This needs the role { $needed }, and you are { $role }; ask an admin for it.
web-larger-mb-make-smaller-try-again = { $name } is larger than { $most_bytes } MB; make it smaller and try again.

## Errors: linescan

linescan-strips-rows-high-least-8-needed = The strips are { $rows } rows high; at least 8 are needed to find a vehicle.
linescan-strips-differ-lines-rows-rows-expected = The strips differ: { $shape } and { $shape_2 } lines by rows, { $rows } rows expected; both cameras must record the same lines.
linescan-cannot-used-give = { $name } of { $value } { $unit } cannot be used; give { $least } to { $most } { $unit }.

## Errors: measurements

measurements-vehicle-not-recording-choose-one-passes = The vehicle is not of this recording; choose one of its passes.
measurements-frame-clicked-twice-click-two-points = Frame { $twice } is clicked twice; click the two points on another frame of the pass.
measurements-point-not-any-picture-click-again = The { $word } point { $point }, { $point_2 } is not in any picture; click again.
measurements-no-road-pose-yet-make-choose = { $name } has no road pose yet; make or choose one on the road pose page first.
measurements-road-pose-pictures-x-px-not = The road pose of { $name } is for pictures of { $size_px } x { $size_px_2 } px, not for its own size; make or choose another one on the road pose page.
measurements-frame-not-part-vehicle-go-frame = Frame { $frame } does not part vehicle { $number }; go to a frame after its first ({ $first_frame }) and up to its last ({ $last_frame }).
measurements-only-two-passes-same-recording-joined = Only two passes of the same recording can be joined; choose another one.
measurements-vehicles-both-measurements-measurement-stays-vehicle = Vehicles { $number } and { $number_2 } both have measurements, and a measurement stays with its vehicle; discard one of the passes instead.
measurements-vehicle-measured-before-after-frame-measurement = Vehicle { $number } was measured before and after frame { $frame }, and a measurement stays with its vehicle; split at another frame.
measurements-vehicles-csv-missing-though-audit-event = vehicles.csv: { $missing } is missing, though its audit event is there.
measurements-vehicles-csv-not-what-audit-events = vehicles.csv: { $id } is not what its audit events say; it was changed.
measurements-measurement-withdrawn-restore-before-you-change = This measurement is withdrawn; restore it before you change it.
measurements-repeat-stands-clicked-withdraw-click-again = A repeat stands as it was clicked; withdraw it and click it again.
measurements-measurement-withdrawn-already-restore-use-again = This measurement is withdrawn already; restore it to use it again.
adjusting-says-something-else-now = The traffic now says something else than was shown; look at it again.
adjusting-not-an-adjusted-pose-in-force = This is not an adjusted pose in force, so there is nothing to take back.
computing-undo-cannot-be-undone = An undo is not undone; compute the heights again instead.
computing-undone-already = This was undone already; compute the heights again to have its heights back.
computing-undo-the-later-first = Heights were computed again at { $when }; undo that first.
computing-computings-csv-not-what-event-says = computings.csv: { $id } is not what its audit event says; take the whole export again.
computing-computing-made-other-revisions = computings.csv: { $id } made another number of revisions than it says; take the whole export again.
computing-computing-missing = computings.csv: { $id } is missing, though its audit event is there; take the whole export again.
computing-verdict-went-over = revisions.csv: revision { $revision } of measurement { $name } has a verdict that was given to another height; take the whole export again.
measurements-measurement-not-withdrawn-nothing-restore = This measurement is not withdrawn, so there is nothing to restore.
measurements-deleted-vehicle-restore-first = { $name } deleted vehicle { $vehicle_number } at { $when }; restore it first.
measurements-changed-measurement-utc-look-again = { $name } changed this measurement at { $created_at } UTC; look again.
measurements-repeat-needs-vehicle-target-measurement-repeats = A repeat needs the vehicle and the target of the measurement that it repeats.
measurements-road-pose-belongs-another-survey-choose = Road pose { $pose_id } belongs to another survey; choose one of this survey's.
measurements-measurement-without-height-needs-reason-why = A measurement without a height needs the reason why; compute it again.
measurements-measurement-no-height-needs-reason-why = A measurement that has no height needs the reason why; compute it again.
measurements-measurement-stored-another-vehicle-already-click = This measurement was stored for another vehicle already; click again.
measurements-frame-not-picture-clicked-load-again = Frame { $frame } is not the picture that was clicked on; load it again.
measurements-measurements-csv-lacks-measurement-revisions-csv = measurements.csv lacks a measurement that revisions.csv holds; one was taken out.
measurements-says-clicks-give-one-wrong = { $name } says { $status }, its clicks give { $status_2 }; one is wrong.
measurements-names-another-pose-file-pose-changed = { $path }: { $id } names another pose file than its pose; it was changed.
measurements-measurement-no-audit-event-revision-put = { $path }: measurement { $key } has no audit event for revision { $key_2 }; it was put in.
measurements-measurement-differs-audit-event-changed = { $path }: measurement { $key } differs from its audit event; it was changed.
measurements-revisions-csv-measurement-no-revisions-one = revisions.csv: measurement { $id } has no revisions; one was taken out.
measurements-missing-no-road-pose-take-whole = { $path } is missing or is no road pose; take the whole export again.
measurements-says-clicks-give-one-wrong-2 = { $name } says { $words } { $told }, its clicks give { $computed }; one is wrong.
measurements-measurements-csv-another-last-revision = measurements.csv: { $id } has another { $column } than its last revision.
measurements-another-measurements-csv-one-wrong = { $path }: { $id } has another { $name } than measurements.csv; one is wrong.
measurements-where-belongs-row-taken-out-put = { $path } { $found } where { $name } belongs; a row was taken out or put in.
measurements-not-measurements-csv-put = { $path }: { $row } is not in measurements.csv; it was put in.
measurements-measurements-csv-u95-not-1-96 = measurements.csv: { $id } has a U95 that is not 1.96 u; one is wrong.
measurements-budget-csv-contributions-give-m-measurements = budget.csv: the contributions to { $id } give { NUMBER($total, minimumFractionDigits: 6, maximumFractionDigits: 6) } m, measurements.csv says { NUMBER($told, minimumFractionDigits: 6, maximumFractionDigits: 6) } m; one is wrong.
measurements-budget-csv-not-what-audit-event = budget.csv: the contributions to { $id } differ from its audit event; one was changed.
cameras-calibration-of-other-images = calibrations.csv: { $id } names other images than its audit events; take the whole export again.
measurements-event-another-row = audit.csv: an event of measurement { $id } holds another row than it hashed; it was changed.
measurements-events-two-frames = audit.csv: two events tell of frame { $frame } of recording { $recording } otherwise; one was changed.
measurements-frames-csv-not-as-clicked = frames.csv: frame { $frame } of recording { $recording } is not what the audit events of its measurements say; it was changed.
measurements-budget-csv-not-measurements-csv-put = budget.csv: { $next } is not in measurements.csv; it was put in.
measurements-revisions-csv-revision-measurement-missing-though = revisions.csv: revision { $revision } of measurement { $number } is missing, though its audit event is there; it was taken out.
measurements-clicked-another-frame-frames-csv-tells = { $path }: { $id } was clicked on another frame than frames.csv tells; one is wrong.

## Errors: media

media-ingest-cancelled-nothing-kept = The ingest of { $name } was cancelled; nothing of it was kept.
media-claims-x-pixels-more-side-million = { $name } claims { $width } x { $height } pixels, more than { $max_side_px } on a side or { $max_pixels } million in all; make it smaller and try again.
media-damaged-cannot-decoded-save-png-jpeg = { $name } is damaged and cannot be decoded; save it as PNG or JPEG and try again.
media-empty-choose-picture = { $name } is empty; choose a picture.
media-heif-picture = { $name } is a HEIC or AVIF picture, which cannot be read here; save it as PNG or JPEG and try again.
media-not-picture-read-here-save-png = { $name } is not a picture that can be read here; save it as PNG or JPEG and try again.
media-damaged-header-not-say-how-large = { $name } is damaged: its header does not say how large it is; save it as PNG or JPEG and try again.
media-picture-shape-could-not-encoded = A picture of shape { $shape } could not be encoded as { $suffix }.
media-larger-mb-make-smaller = { $name } is larger than { $max_bytes } MB; make it smaller.
media-cannot-read-check-path = { $name } cannot be read ({ $strerror }); check the path.

## Errors: store

store-no-media-address-use-folder-file = { $media_url } is no media address; use a folder, file:///folder or s3://bucket.
store-no-room-needed-free-delete-recordings = There is no room for { $what } ({ $needed } needed, { $free } free); delete recordings that are no longer needed or add disk space, then try again.
store-no-media-file = There is no media file { $key }.
store-storage-s3-needs-local-cache-folder = Storage on S3 needs a local cache folder; name one beside the media address.
store-disk-full-not-stored-delete-recordings = The disk is full, { $what } was not stored; delete recordings that are no longer needed or add disk space, then try again.
store-media-file-missing-store-restore-backup = The media file { $key } is missing from the store; restore it from a backup.
store-media-storage-did-not-answer-check = The media storage did not answer for { $key } ({ $name }); check its address, its credentials and that it is running.
store-names-no-bucket-write-s3-bucket = { $url } names no bucket; write s3://bucket/prefix.
store-media-file-missing-store = The media file { $key } is missing from the store.
store-no-such-upload-finished-given-up = There is no such upload; it was finished or given up, start it again.
store-file-empty-choose-video-file = The file is empty; choose a video file.
store-upload-not-complete-bytes-arrived-continue = The upload is not complete: { $have } of { $size } bytes have arrived; continue it.
store-upload-stands-byte-not-continue = The upload stands at byte { $have }, not { $at }; continue from there.
store-upload-name-already-under-way-start = An upload with this name is already under way; start a new one.
store-upload-being-written-another-connection-try = This upload is being written by another connection; try again.
store-more-bytes-came-announced-start-upload = More bytes came than the { $size } announced; start the upload again.

## Errors: strips

strips-no-json-object-correct-them = { $what } are no JSON object; correct them.
strips-give-line-rate-hz-no-positive = { $what } give a line_rate_hz that is no positive number; correct it.
strips-give-dropped-lines-no-list-line = { $what } give dropped_lines that are no list of [line, count] in order; correct them.
strips-larger-mb-correct-remove-file = { $what } are larger than { $sidecar_bytes } MB; correct or remove that file.
strips-not-readable-json-correct-remove-file = { $what } are not readable JSON; correct or remove that file.
strips-cut-off-header-copy-again-recorder = { $name } is cut off in its header; copy it again from the recorder.
strips-problem = { $name } { $kinds }; { $grey }.
strips-bits-pixel = { $name } has { $depth } bits a pixel; { $grey }.
strips-interlaced-cannot-read-pieces-save-without = { $name } is interlaced and cannot be read in pieces; save it without interlacing.
strips-pixels-wide-png-here-save-tiff = { $name } is { $width_px } pixels wide, a PNG can have { $most_wide_px } here; save it as TIFF or with time along the height.
strips-damaged-checksum-inside-not-match-copy = { $name } is damaged: a checksum inside does not match; copy it again from the recorder.
strips-no-plain-picture-animation-damaged = { $name } is no plain picture (an animation, or damaged); { $grey }.
strips-give-png-tiff-line-scan-camera = { $name } { $what }; give a PNG or TIFF of the line-scan camera.
strips-pixels-line-give-two-strips-equal = { $name } has { $rows } pixels a line and { $name_2 } { $rows_2 }; give two strips of equal height, or cut them to the part of the scene that both show.
strips-bits-pixel-save-both-alike = { $name } has { $value } bits a pixel and { $name_2 } { $value_2 }; save both alike.
strips-lines-both-begin-end-together-give = { $name } has { $lines } lines and { $name_2 } { $lines_2 }; both begin and end together, so give the two strips of one recording, or cut them to the same time.
strips-not-file-give-png-tiff-line = { $name } is not a file; give a PNG or TIFF of the line-scan camera.
strips-jpeg-which-changes-pixels-save-png = { $name } is a JPEG, which changes the pixels; save it as PNG or TIFF in the recorder.
strips-would-pixels-line-time-along-more = { $name } would have { $rows } pixels a line with time along its { $time_axis }, more than { $most_rows }; { $hint }.
strips-lines-pixels-time-along-which-shows = { $name } has { $lines } lines of { $rows } pixels with time along its { $time_axis }, which shows no vehicle; give a PNG or TIFF of the line-scan camera.
strips-more-thousand-million-lines-cut-into = { $name } has more than { $most_lines } thousand million lines; cut it into parts.
strips-notes-say-lines-lost-record-again = { $name }: its notes say that { $lost } lines were lost of { $lines }; record it again.
strips-notes-name-lost-lines-ends-correct = { $name }: its notes name lost lines at { $line }, but it ends at { $lines }; correct them.
strips-cannot-read-give-png-tiff-line = { $name } cannot be read ({ $strerror }); give a PNG or TIFF of the line-scan camera.
strips-cut-off-ends-row-copy-again = { $name } is cut off: it ends in row { $row } of { $height }; copy it again from the recorder.
strips-damaged-row-cannot-read-copy-again = { $name } is damaged at row { $row } of { $height } and cannot be read on; copy it again from the recorder.
strips-claims-picture-x-pixels-copy-again = { $name } claims a picture of { $width } x { $height } pixels; copy it again from the recorder.
strips-claims-x-pixels-more-mb-file = { $name } claims { $width } x { $height } pixels, more than { $file_bytes } MB of file can hold; it is damaged or no recording: copy it again from the recorder.
strips-rows-pixels-too-long-read-copy = { $name } has rows of { $width_px } pixels, too long to be read; copy it again from the recorder.
strips-stored-strip-damaged-restore-backup-read = The stored strip { $name } is damaged; restore it from a backup or read it again.
strips-stored-strip-missing-restore-backup = The stored strip { $name } is missing; restore it from a backup.
strips-strip-no-level-only-0 = The strip { $name } has no level { $level }, only 0 to { $count }.
strips-gain-cannot-shown-choose-one-0 = The gain { $gain } cannot be shown; choose one from 0.1 to 50.
strips-strip-no-tile-level = The strip { $name } has no tile { $index } in level { $level }.
strips-index-pixels-not-fit-size = has an index of its pixels that does not fit its size; { $again }
strips-holds-several-pictures-give-each-strip = { $name } holds several pictures; give each strip as one long picture.
strips-palette-line-scan-grey = { $name } has a palette, and a line scan is grey; { $grey }.
strips-colour-transparency-channel-line-scan-grey = { $name } is in colour or has a transparency channel, a line scan is grey; { $grey }.
strips-holds-signed-floating-point-numbers = { $name } holds signed or floating-point numbers; { $grey }.
strips-bits-pixel-2 = { $name } has { $bitspersample } bits a pixel; { $grey }.
strips-packed-which-not-read-here-save = { $name } is packed with { $kind_name }, which is not read here; save it with zstd, deflate or LZW compression, or with none.
strips-packed-unusual-way-save-zstd-deflate = { $name } is packed in an unusual way; save it with zstd, deflate or LZW compression, or with none.
strips-marked-turned-mirrored-save-upright = { $name } is marked as turned or mirrored; save it upright.
strips-tiff-cut-off-whose-directory-damaged = { $name } is a TIFF that is cut off or whose directory is damaged; { $again }.
strips-packed-pieces-more-mb-save-smaller = { $name } is packed in pieces of more than { $piece_bytes } MB; save it in smaller strips or tiles.
strips-rows-tiles-more-mb-save-smaller = { $name } has rows of tiles of more than { $piece_bytes } MB; save it in smaller tiles.
strips-problem-2 = { $name } { $message }.
strips-tiff-whose-directory-damaged = { $name } is a TIFF whose directory is damaged; { $again }.
strips-frames-too-few-line-scan-choose = { $name } has { $count } frames, too few for a line scan; choose another recording.
strips-no-constant-frame-rate-time-stamps = { $name } has no constant frame rate (its time stamps are uneven, most of all after frame { $at }), and a line scan needs one; cut out an even part, or record with a fixed frame rate.
strips-columns-cannot-cut-choose-two-different = The columns { $columns_px } and { $columns_px_2 } cannot be cut from { $name }; choose two different ones from 0 to { $width }.
strips-now-gives-frames-not-ingest-again = { $name } now gives { $count } frames, not { $count_2 }; ingest it again.

## Errors: video

video-not-file-choose-video-file = { $name } is not a file; choose a video file.
video-problem = { $name } { $reason }; { $way_out }.
video-holds-no-moving-picture-only-sound = { $name } holds no moving picture, only sound or data; choose a video file.
video-uses-video-codec-cannot-decoded-here = { $name } uses a video codec that cannot be decoded here; convert it to MP4 with H.264 or choose another file.
video-not-say-how-large-picture-says = { $name } does not say how large its picture is, or says it absurdly; convert it to MP4 with H.264 or choose another file.
video-claims-picture-x-pixels-more-side = { $name } claims a picture of { $width } x { $height } pixels, more than { $max_side_px } on a side or { $max_pixels } million in all; convert it to MP4 with H.264 or choose another file.
video-claims-pixels-width-height-which-not = { $name } claims pixels of { $aspect } width to height, which is not believable; convert it to MP4 with H.264 or choose another file.
video-not-video-read-here-convert-mp4 = { $name } is not a video that can be read here; convert it to MP4 with H.264 or choose another file.
video-holds-no-picture-decoded-codec-convert = { $name } holds no picture that can be decoded (codec { $codec }); convert it to MP4 with H.264 or choose another file.
video-holds-no-picture-decoded-convert-mp4 = { $name } holds no picture that can be decoded; convert it to MP4 with H.264 or choose another file.
video-recording-ended-decoder-times-set-aside = This recording ended the decoder { $count } times and is set aside; convert the recording to MP4 with H.264 and upload it again.
video-decoder-ended-again-again-look-memory = The decoder ended again and again; look at the memory of this machine.
video-cannot-decoded-decoder-save-another-format = { $header } cannot be decoded: the decoder { $why }; save it in another format and try again.
video-frame-no-longer-wanted = This frame was no longer wanted.
video-no-frame-recording-frames-0 = There is no frame { $n }; this recording has frames 0 to { $count }.
video-crop-x-pixels-scale-out-bounds = A crop of { $w } x { $h } pixels at scale { $scale } is out of bounds; ask for a smaller one.
video-holds-no-picture-decoded-copy-again = { $name } holds no picture that can be decoded; copy it again or convert it to MP4.
video-changes-picture-size-way-split-where = { $name } changes its picture size on the way; split it where the size changes.
video-proposals-cancelled = Making proposals for { $name } was cancelled; nothing of it was kept.
video-search-passes-cancelled-nothing-kept = The search for passes in { $name } was cancelled; nothing of it was kept.
video-cannot-made-addressable-frame-frame-convert = { $name } cannot be made addressable frame by frame; convert it to MP4 with H.264 and try again.
video-disk-full-not-taken-make-room = The disk is full, { $name } was not taken in; make room and try again.
video-frame-cannot-shown-stored-video-no = Frame { $n } cannot be shown: the stored video no longer gives the picture whose checksum was written down at ingest; restore the file from a backup or ingest it again as a new recording.
video-stored-video-missing-no-longer-opened = The stored video { $name } is missing or can no longer be opened; restore it from a backup.
video-frame-no-longer-wanted-2 = Frame { $n } was no longer wanted.
video-needs-bgr-frames-one-even-size = { $name } needs BGR frames of one even size, got { $shape } for { $width } x { $height }.
video-cannot-written-without-frames = { $name } cannot be written without frames.

## Errors: people

people-email-password-not-fit-together-check = This email and password do not fit together; check both and try again.
people-password-characters-choose-another = A password has { $min_password } to { $max_password } characters; choose another.
people-current-password-not-right-type-again = The current password is not right; type it again.
people-no-active-account-check-address = There is no active account for { $email }; check the address.
people-too-many-failed-sign-ins-wait = Too many failed sign-ins; wait five minutes and try again.
people-sign-link-used-already-too-old = This sign-in link was used already or is too old; ask an admin for a new one.
people-not-email-address-write-name-place = “{ $email }” is not an email address; write it as name@place.
people-already-account-change-one-instead = There is already an account for { $email }; change that one instead.
people-last-admin-make-somebody-else-admin = This is the last admin; make somebody else admin first.
people-person-needs-name-fill = A person needs a name; fill it in.
people-no-role-use-one = There is no role “{ $role }”; use one of { $roles }.

## Errors: poses

poses-no-frames-yet-wait-until-ready = { $name } has no frames yet; wait until it is ready.
poses-frames-no-span-frames-0 = Frames { $first_frame } to { $last_frame } are no span of { $name }; it has frames 0 to { $frame_count }.
poses-no-frame-shows-board = No frame from { $first } to { $last } shows the board: { $reason }{ $reason_2 }.
poses-calibration-pictures-x-px-x-px = The calibration is for pictures of { $width_px } x { $height_px } px and { $name } has { $width_px_2 } x { $height_px_2 } px; choose a calibration made at the recording's size.
poses-calibration-belongs-another-survey-choose-one = Calibration { $calibration_id } belongs to another survey; choose one of this survey's.

## Errors: quality

quality-no-recording-uses-road-pose-any = No recording uses this road pose any more; look at the checks again.
quality-traffics-direction-now-not-what-you = The traffic's direction is now { $turn_deg }°, not what you saw; look again.
quality-frame-not-vehicle-which-passes-frames = Frame { $frame } is not of vehicle { $number }, which passes in frames { $first_frame } to { $last_frame }; go to one of them.
quality-wheel-pairs-csv-not-what-audit = wheel_pairs.csv: { $id } is not what its audit event says; it was changed.
quality-clicked-their-own-measurements-again-needed = { $name } clicked { $pairs } of their own measurements again; { $least_pairs } are needed for a sigma of their own. Click more of them again.
quality-repeats-csv-repeat-missing-though-audit = repeats.csv: repeat { $left } is missing, though its audit event is there.
quality-repeats-csv-not-what-audit-event = repeats.csv: { $number } is not what its audit event says; it was changed.

## Errors: recordings

recordings-images-add-least-three-better-15 = { $name } has { $images } images; add at least three, better 15 to 25.
recordings-belongs-another-survey-choose-one-surveys = { $name } belongs to another survey; choose one of this survey's.
recordings-no-frames-yet-wait-until-ingest = { $name } has no frames yet; wait until its ingest is done.
recordings-no-road-pose-yet-nothing-says = { $name } has no road pose yet, so nothing says where its camera stood.
recordings-still-being-ingested-wait-until-ready = { $name } is still being ingested; wait until it is ready.
recordings-could-not-ingested-no-frames-see = { $name } could not be ingested, so it has no frames; see its error and try again.
recordings-frame-table-not-whole-ingest-recording = The frame table of { $name } is not whole; ingest the recording again.
recordings-recording-no-frame-choose-one-within = Recording { $recording_id } has no frame { $n }; choose one within the recording.
recordings-frame-no-thumbnail-ask-frame-itself = Frame { $n } of { $name } has no thumbnail; ask for the frame itself.
recordings-being-ingested-already-wait-cancel = { $name } is being ingested already; wait for it or cancel it.
recordings-ingest-cancelled-start-again-delete-recording = The ingest was cancelled; start it again or delete the recording.
recordings-being-ingested-cancel-first = { $name } is being ingested; cancel that first.
recordings-recordings-cannot-changed-leave-out = A recording's { $unknown } cannot be changed; leave it out.
recordings-recording-needs-name-fill = A recording needs a name; fill it in.
recordings-street-lighting-on-or-off = Street lighting is on or off; choose one.
recordings-start-in-future = { $start } in { $zone } has not come yet; give the time at which the recording was begun.
recordings-start-too-early = There was no digital video in { $start }; give the day on which the recording was begun.
recordings-misfit-size = Its pictures are { $width } x { $height } px and its camera’s calibration is for { $lens_width } x { $lens_height } px: film at the calibrated size, or calibrate at this one.
recordings-misfit-focal = Its file states a focal length of { $stated_mm } mm on 35 mm film and its camera’s calibration is of about { $lens_mm } mm: was the zoom another one?
local-time-unknown-zone = { $zone } is no time zone of the IANA list; choose one such as Europe/Paris.
local-time-cannot-read = { $text } cannot be read as a time; write it as 2026-05-03T08:10:00.
local-time-skipped = { $time } does not exist in { $zone }, where clocks went forward over it; give the time that they showed ({ $before } before the change, { $after } after it).
local-time-twice = { $time } comes twice in { $zone }, where clocks went back; say whether it is the first ({ $first }) or the second ({ $second }).
local-time-other-offset = At { $time } clocks in { $zone } are at { $offset }; give that offset or none.
measurements-filmed-at-another-time = measurements.csv: { $id } was filmed at another time than its recording’s start gives; one of them was changed.
measurements-vehicles-csv-other-time = vehicles.csv: { $id } was filmed at another time than its recording’s start gives; one of them was changed.
recordings-lighting-daytime-low-light-choose-one = The lighting is daytime or low_light; choose one.
recordings-recording-measurements-stays-audit-needs-frames = This recording has measurements and stays; an audit needs its frames.
recordings-camera-not-found-moved-since-road = The camera was not found to have moved since the road pose; there is nothing to decide.
recordings-say-why-road-pose-still-good = Say why the road pose is still good, so that an audit can follow it.
recordings-nothing-decided-about-recordings-camera-nothing = Nothing was decided about this recording's camera, so there is nothing to take back.
recordings-belongs-another-survey-choose-one-surveys-2 = The { $word } { $row_id } belongs to another survey; choose one of this survey's.
recordings-road-pose-pictures-x-px-x = The road pose { $pose_id } is for pictures of { $posed } x { $posed_2 } px and { $name } has { $filmed } x { $filmed_2 } px; choose a pose made at the recording's size.
recordings-frames-found-now-not-those-measured = The frames found now are not those that were measured; upload the video as a new one.
recordings-uploads-speak-tus-1-0-0 = Uploads speak tus 1.0.0; send the header Tus-Resumable: 1.0.0.
recordings-upload-not-say-how-long-file = The upload does not say how long the file is; send the header Upload-Length.
recordings-bytes-upload-come-application-offset-octet = The bytes of an upload come as application/offset+octet-stream; send that Content-Type.
recordings-upload-not-name-file-send-filename = The upload does not name its file; send filename in the header Upload-Metadata.
recordings-uploads-purpose-video-strip-send-one = The upload's purpose is video or strip; send one of them in Upload-Metadata.
recordings-uploads-cannot-read-send-base64-utf = The upload's { $word } cannot be read; send it as base64 of UTF-8.
recordings-upload-finished-already-look-recording-list = This upload is finished already; look for its recording in the list.
recordings-upload-became-recording-deleted-since-upload = This upload became a recording that was deleted since; upload it again.
recordings-upload-finished-already-make-scan = This upload is finished already; make the scan of it.
recordings-upload-finished-delete-recording-instead = This upload is finished; delete its recording instead.
recordings-recordings-csv-not-what-audit-events = recordings.csv: { $id } is not what its audit events say; it was changed.

## Errors: results

results-cannot-read-take-whole-export-again = { $path }: { $name } cannot be read; take the whole export again.
results-database-holds-which-version-not-know = The database holds the { $name } “{ $unknown }”, which this version does not know.
results-reference-heights-u-must-least-0 = The reference heights' u must be at least 0 and below 1 m, such as 0.0173.
results-more-values-your-own-cannot-drawn = More than { $most_own } values of your own cannot be drawn; remove some.
results-value-your-own-must-lie-between = A value of your own must lie between 0 and 10 m, such as 1.08.
results-somebody-changed-standards-meanwhile-load-them = Somebody changed the standards meanwhile; load them again and repeat your change.
results-table-standards-cannot-drawn-most = A table of { $count } standards cannot be drawn; { $most } are the most.
results-stands-table-twice-give-each-value = { $twice } stands in the table twice; give each value a name of its own.
results-standard-needs-name-such-aashto-usa = A standard needs a name, such as AASHTO (USA).
results-height-must-lie-between-0-10 = The height of { $name } must lie between 0 and 10 m, such as 1.08.
results-standard-percent = { $name }: a percentile lies above 0 and below 100; correct it, or leave it empty.
results-last-day-lies-before-first-exchange = The last day lies before the first; exchange them.
results-no-survey-may-been-removed = There is no survey { $survey_id }; it may have been removed.
results-standards-csv-not-what-surveys-audit = standards.csv is not what the survey's audit events say; it was changed.

## Errors: reviews

reviews-fix-needs-both-points-contact-target = A fix needs both points, contact and target; click them and send them along.
reviews-only-fix-carries-points-leave-them = Only a fix carries points; leave them out or choose the verdict fixed.
reviews-measurement-withdrawn-nothing-review = This measurement is withdrawn; there is nothing to review.
reviews-repeat-not-reviewed-review-measurement-repeats = A repeat is not reviewed; review the measurement that it repeats.
reviews-rejection-needs-reason-say-what-wrong = A rejection needs a reason; say what is wrong so that it can be put right.
reviews-fix-needs-new-points-only-fix = A fix needs the new points, and only a fix has them; click them and send them along.
reviews-somebody-changed-plan-meanwhile = Somebody changed the plan meanwhile; load it again and redo yours.
reviews-plan-one-in-between = One in how many is a number between 0 (none) and { $most }.
reviews-click-it-again-before = The survey's plan wants this one clicked again before it is shown; click contact and target, then judge it.
reviews-fix-changes-nothing-accept = This fix changes nothing; move a point, or accept the measurement.
reviews-measurement-waits-review-already = This measurement waits for a review already.
reviews-nobody-reviews-their-own-measurement-ask = Nobody reviews their own measurement; ask another reviewer.
reviews-reviews-csv-not-what-audit-event = reviews.csv: { $id } is not what its audit event says; it was changed.
reviews-reviews-csv-missing-though-audit-event = reviews.csv: { $id } is missing, though its audit event is there.
reviews-measurements-csv-verdict-not-newest-review = measurements.csv: the verdict on { $one } is not that of its newest review; one is wrong.

## Errors: scans

scans-calibrated-line-scan-meanwhile-look-calibration = { $name } calibrated this line scan meanwhile; look at that calibration first.
scans-mark-row-line-lies-outside-strip = A mark at row { NUMBER($row_px, minimumFractionDigits: 1, maximumFractionDigits: 1) }, line { NUMBER($line, minimumFractionDigits: 0, maximumFractionDigits: 0) } lies outside the strip; click it again.
scans-heights-need-line-cameras-pose-calibrate = Heights need the line camera's pose; calibrate the height with a rod first (Calibrate height).
scans-eye-needs-side-say-which = It is not known whether the driver sits on the near or on the far side of this vehicle; choose one of them first.
scans-click-line-row-lies-outside-strip = A click at line { NUMBER($line, minimumFractionDigits: 0, maximumFractionDigits: 0) }, row { NUMBER($row, minimumFractionDigits: 1, maximumFractionDigits: 1) } lies outside the strip; click again.
scans-target-no-height-needs-reason-why = A target that has no height needs the reason why; measure it again.
scans-height-withdrawn-already-nothing-done = This height was withdrawn already; nothing is to be done.
scans-measured-target-meanwhile-look-height-first = { $name } measured this target meanwhile; look at that height first.
scans-calibration-no-row = { $path }: calibration { $marks } is in no row of { $path_2 }.
scans-marks-calibration-not-those-event = { $path }: the marks of calibration { $id } are not those of its event.
scans-row-marked-current-not-newest-revision = { $path }: a row that is marked as current is not the newest revision.
scans-height-no-row = { $path }: height { $budget } is in no row of { $path_2 }.
scans-sources-height-not-those-clicks = { $path }: the sources of height { $id } are not those of its clicks.
scans-marks-clicks-give = { $name } has { $column } { $told }, its marks and clicks give { $computed }.
scans-cannot-solved-marks-one-wrong = { $name } cannot be solved for from its marks; one is wrong.
scans-vehicle-no-measured-motion-no-match = This vehicle has no measured motion, so there is no match to look at.
scans-camera-2s-strip-ends-before-vehicle = Camera 2's strip ends before this vehicle; there is no match to look at.
scans-both-cameras-name-same-upload-upload = Both cameras name the same upload; upload a strip for each.
scans-same-picture-give-strip-each-camera = { $name } and { $name_2 } are the same picture; give the strip of each camera.
scans-frames-uneven-times-line-scan-needs = { $name } has frames at uneven times, and a line scan needs a steady rate; record at a constant frame rate.
scans-columns-cannot-cut-choose-two-different = Columns { $columns } and { $columns_2 } cannot be cut; choose two different ones from 0 to { $width_px }.
scans-read-already-nothing-done = { $name } was read already; nothing is to be done.
scans-could-not-read-see-error-try = { $name } could not be read; see its error and try again.
scans-still-being-read-wait-until-ready = { $name } is still being read; wait until it is ready.
scans-already-wait-cancel = { $name } is { $what } already; wait for that or cancel it.
scans-strip-uploaded-another-survey-upload-one = The { $word } strip was uploaded to another survey; upload it to this one.
scans-uploaded-video-upload-again-strip = { $filename } was uploaded as a video; upload it again as a strip.
scans-belongs-line-scan-recording-already-upload = { $filename } belongs to a line-scan recording already; upload it again.
scans-strip-not-arrived-whole-yet-finish = The { $word } strip, { $filename }, has not arrived whole yet; finish its upload.
scans-changed-look-again-redo-yours = { $name } changed { $name_2 } at { $when }; look again and redo yours.
scans-scans-cannot-changed-leave-out = A scan's { $unknown } cannot be changed; leave it out.
scans-scan-needs-name-fill = A scan needs a name; fill it in.
scans-people-worked-scans-vehicles-stays-audit = People have worked on this scan's vehicles, so it stays; an audit needs its strips.
scans-recording-belongs-another-survey-choose-one = The recording belongs to another survey; choose one of this survey's.
scans-changed-look-again = { $name_of } changed { $name }; look again.
scans-not-been-read-yet-wait-until = { $name } has not been read yet; wait until it is ready.
scans-people-worked-cameras-stay-add-line = People have worked on { $name }, so its cameras stay; add a line scan with the strips the other way round.
scans-vehicle-not-measured-yet-no-wheelbase = This vehicle is not measured yet, so it has no wheelbase; place its boundaries first.
scans-wheel-lies-outside-strips-which-end = A wheel lies outside the strips, which end at line { $lines }.
scans-camera-front-line-must-come-before = At camera { $camera } the front (line { NUMBER($front, minimumFractionDigits: 1, maximumFractionDigits: 1) }) must come before the rear ({ NUMBER($rear, minimumFractionDigits: 1, maximumFractionDigits: 1) }); place them again.
scans-boundaries-camera-lie-outside-strip-which = The boundaries at camera { $camera } lie outside the strip, which ends at line { $lines }; place them again.
scans-front-rear-camera-lines-apart-more = Front and rear at camera { $camera } are { NUMBER($rear, minimumFractionDigits: 0, maximumFractionDigits: 0) } lines apart, more than one vehicle can be; place them again.
scans-nothing-camera-2s-strip-looks-like = Nothing in camera 2's strip looks like this vehicle; place its front and rear there by hand, or leave it out if it is none.
scans-vehicle-no-speed-needs-reason-why = A vehicle that has no speed needs the reason why; measure it again.
scans-vehicle-measured-again-meanwhile-look-newer = This vehicle was measured again meanwhile; look at the newer result.
scans-nobody-reviews-boundaries-they-placed-themselves = Nobody reviews boundaries that they placed themselves; ask another reviewer.
scans-vehicle-waits-review-already = This vehicle waits for a review already.
scans-height-measured-again-meanwhile-look-newer = This height was measured again meanwhile; look at the newer result.
scans-height-without-figure-nothing-review = This height was withdrawn or has no figure, so there is nothing to review.
scans-nobody-reviews-height-they-clicked-themselves = Nobody reviews a height that they clicked or computed themselves; ask another reviewer.
scans-height-waits-review-already = This height waits for a review already.
scans-camera-2-needs-both-lines-front = Camera 2 needs both lines, front and rear, or none; send both or leave both out.
scans-wheelbase-needs-both-wheels-send-both = A wheelbase needs both wheels; send both lines, or none to take them away.
scans-vehicle-not-deleted-nothing-restore = This vehicle was not deleted, so there is nothing to restore.
scans-deleted-vehicle-restore-first = { $name } deleted vehicle { $number } at { $when }; restore it first.
scans-changed-vehicle-look-again-redo-yours = { $name } changed vehicle { $number } at { $when }; look again and redo yours.
scans-scanned-vehicle-no-leave-out = A scanned vehicle has no { $unknown }; leave it out.
scans-m-cannot-used-give-metres-4 = A { $name } of { $value } m cannot be used; give it in metres, as in 4.447.
scans-row-without-audit-event-missing = { $path }: row { $odd } is there without its audit event, or is missing.
scans-row-not-what-audit-event-says = { $path }: { $name } of row { $id } is not what its audit event says.
scans-vehicle-not-newest-revision-changed = { $path }: vehicle { $number } is not its newest revision; it was changed.
scans-verdict-row-not-one-given = { $path }: the verdict of row { $number } is not the one given.

## Errors: statistics

statistics-no-percentile-give-one-between-0 = There is no percentile { $percent }; give one between 0 and 100, such as 10.
statistics-width-spread-must-lengths-above-0 = Width and spread must be lengths above 0, in metres, such as 0.02 and 0.08.

## Errors: surveys

surveys-file-photograph-missing-changed-take-out = The file of the photograph “{ $name }” is missing or was changed; take it out of the survey and add it again.
surveys-survey-takes-photographs-take-one-out = A survey takes { $most_photographs } photographs; take one out before adding another.
surveys-photographs-added-taken-out-meanwhile-look = Photographs were added or taken out meanwhile; look again and redo the order.
surveys-changed-photograph-look-again-redo-yours = { $name } changed this photograph at { $when }; look again and redo yours.
surveys-caption-most-characters-shorten = A caption has at most { $most_caption } characters; shorten it.
surveys-not-photographs-audit-events-changed = { $path } has not the photographs of the audit events; it was changed.
surveys-no-row-put = { $strange } is in no row of { $path }; it was put in.
surveys-not-photograph-audit-event-names-exchanged = { $file } is not the photograph that its audit event names; it was exchanged.
surveys-not-what-audit-events-say-changed = { $path }: { $name } of { $id } is not what its audit events say; it was changed.
surveys-no-survey-named-check-name-home = There is no survey named “{ $name }”; check the name on the home page.
surveys-changed-survey-look-again-redo = { $name } changed this survey at { $when }; look again and redo yours.
surveys-place-half-coordinates = Coordinates are a latitude and a longitude; give both or none.
surveys-place-latitude = A latitude lies between -90 and 90 degrees; { $latitude } does not: are latitude and longitude exchanged?
surveys-place-longitude = A longitude lies between -180 and 180 degrees; { $longitude } does not.
surveys-place-speed-limit = A speed limit lies above 0 and up to { $fastest } km/h; { $kmh } km/h does not.
surveys-survey-needs-name-fill = A survey needs a name; fill it in.
surveys-inset-cannot-used-give-known-target = The inset of “{ $target }” cannot be used; give a known target and an uncertainty >= 0.
surveys-asks-nothing-choose-target = A survey asks for at least one target by day and one in low light; choose them.
surveys-survey-csv-not-what-audit = survey.csv is not what the survey's audit events say; it was changed.
surveys-insets-csv-not-what-surveys-audit = insets.csv is not what the survey's audit events say; it was changed.
surveys-classes-csv-not-what-surveys-audit = classes.csv is not what the survey's audit events say; it was changed.
surveys-sampling-csv-not-what-audit = sampling.csv or quotas.csv is not what the survey's audit events say; it was changed.
surveys-sampling-step = Every n-th pass: n lies between 1 and { $most_step }, the first number between 1 and n; correct them.
surveys-sampling-share = A share of the passes lies above 0 and at most at 100 %; correct it.
surveys-sampling-headway = A headway of free-flowing vehicles lies above 0 and at most at { $most_headway_s } s; correct it.
surveys-sampling-quota-twice = A lighting and set of classes has two quotas; give each one once.
surveys-class-twice = The class { $category } is in the table twice; give each class once.
surveys-class-fhwa = A class of FHWA of { $category } is none of 1 to 13; correct it.

## Errors: vehicles

vehicles-no-row-used-line = No row of { $name } can be used; line { $line }: { $reason }
vehicles-larger-mb-split-into-several-files = { $name } is larger than { $most_bytes } MB; split it into several files.
vehicles-no-column-first-line-names-columns = { $name } has no column { $missing }; its first line names the columns, out of { $known }.
vehicles-not-category-use-one = “{ $category }” is not a category; use one of { $categories }.
vehicles-which-not-year-give-four-digits = { $column } is “{ $cell }”, which is not a year; give four digits.
vehicles-cannot-read-csv-near-line-save = { $name } cannot be read as CSV near line { $line_num } ({ $problem }); save it again as CSV.
vehicles-not-utf-8-text-save-csv = { $name } is not a UTF-8 text; save it as CSV in UTF-8.
vehicles-which-not-number-give-metres = { $column } is “{ $cell }”, which is not a number; give it in metres.
vehicles-gives-frames-now-gave-when-read = { $name } gives { $count } frames now and gave { $count_2 } when it was read; read it again.
vehicles-search-passes-cancelled-start-again-when = The search for passes was cancelled; start it again when you like.
vehicles-passes-being-looked-already-wait = Passes of { $name } are being looked for already; wait for that.
vehicles-vehicle-needs-first-last-frame-mark = A vehicle needs its first and last frame; mark the pass on the timeline.
vehicles-vehicle-no-leave-out = A vehicle has no { $unknown }; leave it out.
vehicles-frames-not-span-recording-ends-frame = Frames { $first } to { $last } are not a span of this recording; it ends at frame { $end }.
vehicles-best-frame-lies-outside-frames-choose = The best frame { $best } lies outside frames { $first } to { $last }; choose one of them.
vehicles-no-driver-only-eye-choose-another = “No driver seen” is a reason for the driver’s eye, not for { $target }; choose another.
vehicles-manufacturers-height-m-cannot-used-give = A manufacturer’s height of { $height } m cannot be used; give it in metres, as in 1.624.
vehicles-uncertainty-m-cannot-used-give-metres = An uncertainty of { $u_height } m cannot be used; give it in metres, as in 0.005.

## Errors: what the framework refuses, and what was said before

said = { $sentence }
request-needs-header = Requests that change something need the header { $header }; add it and send it again.
request-from-another-site = This request comes from another site and was refused; use Sightline's own pages.
request-no-json = The request's body is not valid JSON; send a JSON object.
request-cannot-be-used = The { $place } of the request cannot be used: { $said }; correct it and send it again.
request-value-cannot-be-used = The value "{ $name }" of the { $place } cannot be used: { $said }; correct it and send it again.
request-nothing-there = There is nothing at { $path }; check the address.
request-bad-method = { $method } is not possible at { $path }; see /docs for what is.
request-refused = { $detail }; correct it and try again.
request-value-not-storable = A value in the request cannot be stored; correct it and send it again.
server-something-went-wrong = Something went wrong on the server and nothing was saved; the server's log says what.

## Errors: another person was quicker

quality-tyres-changed-meanwhile = { $name } changed the tyres of this vehicle meanwhile; look at them first.
measurements-discarded-but-measured-withdraw = Vehicle { $number } is measured, so it cannot be discarded; withdraw its measurements first.
measurements-vehicles-csv-not-in-sample = vehicles.csv: whether vehicle { $id } is in the sample is not what sampling.csv and the passes give; it was changed.
measurements-not-visible-but-measured-withdraw = { $target } is measured of this vehicle, so it is visible; withdraw the measurement first.
measurements-already-measured = { $name } has measured this target of the vehicle already; keep one of the two.
lots-tab = Lots
lots-lead = Instead of one by one, heights can be reviewed by lots: a sample is judged, and the lot is accepted by it or inspected whole. The plan says how often either would be a mistake.
lots-loading = the lots
lots-summary = Accepted by a verdict of their own: { $individual }; by their lot’s sample: { $by_lot }.
lots-outgoing = { $count ->
    [one] Of the 1 that nobody looked at, { $estimate } is wrong by estimate and { $most } at most ({ $share }, one-sided 95 %).
   *[other] Of the { $count } that nobody looked at, { $estimate } are wrong by estimate and { $most } at most ({ $share }, one-sided 95 %).
  }
lots-held = { $count ->
    [one] 1 height waits for its lot’s sample.
   *[other] { $count } heights wait for their lot’s sample.
  }
lots-draw-title = Draw lots from what waits
lots-draw = Draw
lots-by = Heights of a lot have in common
lots-by-target = target
lots-by-lighting = lighting
lots-by-operator = who measured
lots-by-day = day measured
lots-producer-quality = A lot with so many wrong should pass
lots-producer-risk = chance that it does not
lots-consumer-quality = A lot with so many wrong should not pass
lots-consumer-risk = chance that it does
lots-nonconforming = Wrong (nonconforming) is a height that its reviewer rejects, or fixes by more than its own U95. The sample is drawn by a seed from the audit chain before anybody judges. The acceptance criterion is that of ISO 2859; its tables are not used: the plan is computed for each lot’s size.
lots-nothing-waits = Nothing waits for a verdict outside of lots.
lots-planned = Lots that could be drawn
lots-lot = lot
lots-size = heights
lots-sample = sample
lots-number = wrong ones allowed
lots-what = what it saves
lots-saves = { $count ->
    [one] 1 verdict
   *[other] { $count } verdicts
  }
lots-saves-nothing = nothing: the sample is the whole lot; review it one by one
lots-everything = everything that waited
lots-named = Lot { $number }: { $common }
lots-of = { NUMBER($part) } of { NUMBER($all) }
lots-judged = sample judged
lots-bad = wrong
lots-state = state
lots-state-open = open
lots-state-accepted = accepted
lots-state-full_inspection = full inspection
lots-state-dissolved = dissolved
lots-state-taken_back = taken back
lots-left = Left the lot: { $reasons }.
lots-left-measured_again = { $count } measured again
lots-left-withdrawn = { $count } withdrawn
lots-left-vehicle_deleted = { $count } whose vehicle was deleted
lots-left-verdict_of_its_own = { $count } with a verdict of their own
lots-plan = { $size } heights, a sample of { $sample }, accepted with at most { $most } wrong.
lots-says-waits = { $count ->
    [one] 1 of the sample still waits for its verdict.
   *[other] { $count } of the sample still wait for their verdict.
  }
lots-says-accept = { $count ->
    [one] The sample is judged: 1 is wrong, { $most } may be. The lot can be accepted.
   *[other] The sample is judged: { $count } are wrong, { $most } may be. The lot can be accepted.
  }
lots-says-refused = { $count ->
    [one] 1 of the sample is wrong, and { $most } may be: the rest goes to full inspection.
   *[other] { $count } of the sample are wrong, and { $most } may be: the rest goes to full inspection.
  }
lots-says-accepted = { $count ->
    [one] Accepted: { $bad } of the sample wrong, 1 height accepted by it. Of that, { $estimate } is wrong by estimate and { $most } at most ({ $share }, one-sided 95 %).
   *[other] Accepted: { $bad } of the sample wrong, { $count } heights accepted by it. Of these, { $estimate } are wrong by estimate and { $most } at most ({ $share }, one-sided 95 %).
  }
lots-says-inspected = { $count ->
    [one] Not accepted by its sample: 1 height went to the queue.
   *[other] Not accepted by its sample: { $count } heights went to the queue.
  }
lots-says-taken-back = { $count ->
    [one] Accepted, then taken back: 1 height waits again.
   *[other] Accepted, then taken back: { $count } heights wait again.
  }
lots-says-dissolved = Dissolved before anything was judged.
lots-judge = Judge the sample
lots-accept = Accept the lot
lots-inspect = Full inspection
lots-inspect-text = { $count ->
    [one] 1 height of the rest goes to the queue and enters no other lot.
   *[other] { $count } heights of the rest go to the queue, each for itself, and enter no other lot.
  }
lots-dissolve = Dissolve
lots-take-back = Take back
lots-own = { $count ->
    [one] 1 of the sample is your own; somebody else judges it.
   *[other] { $count } of the sample are your own; somebody else judges them.
  }
lots-drawn = Drawn { $when } by { $person }; seed { $seed }…
lots-nobody = the program
lots-curve = How often such a lot is accepted
lots-curve-says = The probability that the plan accepts a lot, falling with the share of wrong heights in it: with { $good } wrong it is not accepted in { $refused } of cases, with { $bad } it is accepted in { $passed }.
lots-curve-note = Exact for a lot of this size (hypergeometric). With { $good } wrong, { $refused } of such lots are not accepted; with { $bad }, { $passed } are.
lots-curve-x = wrong heights in the lot (%)
lots-curve-y = accepted (%)
lots-producer = should pass
lots-consumer = should not pass
lots-sample-of = sample of lot { $number }
lots-badge = lot { $number }
lots-sample-done = This lot’s sample is judged.
lots-show-all = Show all
lots-by-lot = Accepted by the sample of its lot; nobody looked at this one.
lots-fraction-between = A fraction nonconforming is a number from 0 to below 1, such as 0.01 for 1 in 100.
lots-risk-between = A risk is a number between 0.001 and 0.5, such as 0.05 for 1 in 20.
lots-fractions-in-order = The fraction of a lot that should pass has to be smaller than that of one that should not; change one of them.
lots-nothing-to-draw = No lot would save anything: what waits is too little for these risks, or in lots already. Divide it less, or review it one by one.
lots-sample-not-judged = { $count ->
    [one] 1 height of the sample still waits for its verdict; judge it first.
   *[other] { $count } heights of the sample still wait for their verdict; judge them first.
  }
lots-too-many = { $count ->
    [one] 1 height of the sample is nonconforming; this lot is accepted with { $most } at most, so its rest goes to full inspection.
   *[other] { $count } heights of the sample are nonconforming; this lot is accepted with { $most } at most, so its rest goes to full inspection.
  }
lots-own-heights = Nobody accepts heights of their own: the rest of this lot holds some of yours. Ask another reviewer.
lots-judged-already = Some of this sample is judged already, so the draw stands; accept the lot or inspect it fully.
lots-not-accepted = Only an accepted lot can be taken back; look at what became of this one.
lots-decided-already = Lot { $number } was decided on meanwhile; look at it first.
lots-event-another-row = audit.csv: event { $number } holds another lot than it hashed; take the whole export again.
lots-verdict-of-no-lot = reviews.csv: a verdict by lot { $lot }, of which there is none; take the whole export again.
lots-lots-csv-not-what-event-says = lots.csv: lot { $id } is not what its audit events say; it was changed.
lots-lot-missing = lots.csv: lot { $id } is missing, though its audit event is there.
lots-seed-not-the-chains = lots.csv: the seed of lot { $id } does not follow from the audit chain; the draw was chosen.
lots-not-drawn-by-its-seed = audit.csv: lot { $id } was not drawn in the order of its seed; the draw was changed.
lots-plan-keeps-no-risk = lots.csv: the plan of lot { $id } does not keep the risks that it names; it was changed.
lots-decided-otherwise = audit.csv: what was decided on lot { $id } does not follow one from the other; it was changed.
lots-sample-not-the-draws = audit.csv: the sample of lot { $id } is not the first of its draw; it was changed.
lots-counts-not-those-of-verdicts = audit.csv: the counts of lot { $id } are not those of its sample’s verdicts; one is wrong.
lots-accepted-beyond-its-plan = audit.csv: lot { $id } was accepted with more nonconforming heights than its plan allows, or unjudged.
lots-verdicts-not-those-of-its-rest = reviews.csv: the verdicts by lot { $id } are not those of its rest; some were put in or taken out.
lots-verdict-before-the-decision = audit.csv: a verdict by lot { $id } came before its decision; one is wrong.
lots-items-csv-not-what-events-say = lot_items.csv: place { $place } of lot { $id } is not what the audit events say; it was changed.
reviews-verdict-given-meanwhile = { $name } gave the verdict “{ $verdict }” meanwhile; look at it first.

## Sight distance: the page

sight-lead = What measured heights mean for a road: crests that keep a sight distance, by a standard’s heights and by the survey’s own.
sight-loading = Computing the crests ...
sight-form = What the crests are computed from
sight-form-standard = Standard
sight-form-survey = Survey, read by the standard’s rule
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
sight-fleet-begin = What if the fleet were another
sight-fleet-hint = Shares of the classes that were measured, to be changed.
sight-fleet-end = Measured fleet
sight-fleet-measured = { NUMBER($eyes) } eyes, { NUMBER($objects) } objects measured
sight-case = Heights of
sight-case-standard = the standard
sight-case-survey = the survey
sight-case-mix = the other fleet
sight-sentence = What it means
sight-missing = No height of this is left by the filter: { $targets }. Measure and accept some, or show all states.
sight-verdict-alike = { $case ->
    [mix] With the other fleet’s heights
    [study] With the study’s heights
   *[survey] With the survey’s heights
} (eye { $eye }, object { $object }) the crest constant is { $constant } instead of { $standard }, and K for { $distance } is { $k } instead of { $k_standard }. The change of { $change } is within the 95 % interval: the survey gives no reason to build crests differently.
sight-verdict-shorter = { $case ->
    [mix] With the other fleet’s heights
    [study] With the study’s heights
   *[survey] With the survey’s heights
} (eye { $eye }, object { $object }) the crest constant is { $constant } instead of { $standard }, and K for { $distance } is { $k } instead of { $k_standard }. Crests could be { $change } shorter; on a crest built by the standard one sees { $seen }.
sight-verdict-longer = { $case ->
    [mix] With the other fleet’s heights
    [study] With the study’s heights
   *[survey] With the survey’s heights
} (eye { $eye }, object { $object }) the crest constant is { $constant } instead of { $standard }, and K for { $distance } is { $k } instead of { $k_standard }. Crests would have to be { $change } longer; on a crest built by the standard one sees only { $seen }.
sight-verdict-unknown = { $case ->
    [mix] With the other fleet’s heights
    [study] With the study’s heights
   *[survey] With the survey’s heights
} (eye { $eye }, object { $object }) the crest constant is { $constant } instead of { $standard }, a change of K by { $change }. There is no interval ({ $reason }), so whether that is more than chance cannot be said.
sight-cases-title = Crests
sight-cases-distance = { $speed }: { $formula } = { $distance }, rounded up to { $design }
sight-cases-note = { NUMBER($eyes) } eyes and { NUMBER($objects) } objects. Below each value its 95 % interval, which holds the sampling of the percentiles; eye and object are taken as independent, the standard’s heights and the fleet’s shares as exact. Lengths are for the difference of the grades; the last column is what one sees on a crest built by the standard’s heights.
sight-interval = { $low } to { $high }
sight-no-interval = no interval
sight-column-eye = Eye ({ $unit })
sight-column-object = Object ({ $unit })
sight-column-constant = Constant ({ $unit })
sight-column-k = K ({ $unit } per %)
sight-column-length = Least length ({ $unit })
sight-column-seen = Seen on the standard’s crest ({ $unit })
sight-figure-title = K of a crest against design speed
sight-figure-says = K of a crest against design speed, by the standard’s heights and by the survey’s
sight-figure-note = K = S² / C at the sight distance of each design speed, rounded up as in design tables; band: 95 % interval.
sight-figure-x = design speed ({ $unit })
sight-figure-y = K ({ $unit } per %)
sight-besides-title = Sag and curve, which eyes do not change
sight-sag = Sag, by headlights
sight-sag-words = K { $k } { $unit } per %; least length { $length } { $case ->
    [within] (the sight distance lies within the curve)
    [beyond] (the sight distance reaches beyond the curve)
   *[none] (these grades are lit without a curve)
}
sight-curve = Room beside the curve
sight-curve-words = { $offset } from the line of travel to what blocks the view, at the middle of the curve
sight-curve-none = The curve is too sharp for this distance: it would go round more than half a circle.
sight-besides-note = A headlight’s beam rises 1 degree. Heights of what stands beside a curve are not looked at.

## Sight distance: what cannot be computed
sightdistance-heights = Heights of eyes must lie above 0 and of objects at or above 0, all below 10 m; give them in metres.
sightdistance-uncertainty = A standard uncertainty must be 0 or more, and 0 for an object on the road; correct it.
sightdistance-distance = A sight distance must lie above 0 and below 100 km, and a length at or above 0; give metres.
sightdistance-difference = The difference of the two grades must lie above 0 and at most 100 percent; correct it.
sightdistance-speed = A speed of { $speed_kmh } km/h is no design speed; give more than 0 and at most 300 km/h.
sightdistance-gradient = A gradient of { $gradient_percent } % cannot be braked on; give at most 25 %, and downhill less than braking holds.
sightdistance-reaction-deceleration = The reaction time must be 0 or more and the deceleration more than 0; correct them.
sightdistance-manoeuvre-time = Manoeuvre { $manoeuvre } takes { $least } to { $most } s; give a time within.
sightdistance-passing-speed = There is no passing sight distance at { $speed_kmh } km/h; the table runs from 30 to 130 km/h.
sightdistance-headlight = The headlight's height and its beam's rise must not be negative, nor both 0; correct them.
sightdistance-radius = The radius must be above 0, and its curve must hold the distance and the offset; correct them.
sightdistance-shares = The shares of a fleet must sum to 100 %; these sum to { $total_percent } %. Correct them.
sightdistance-share = “{ $share }” is no share of a fleet; write the class, a colon and 0 to 100 percent (suv:40).
sightdistance-class-unseen = The fleet has a share of { $category }, of which the survey measured none; set that share to 0 or measure some.

## Catalogue: the page

catalogue-lead = Manufacturers’ sizes of models, each with its source: what measured heights and lengths are compared with.
catalogue-loading = Loading the catalogue ...
catalogue-search = Search by make, model and year
catalogue-which = Which models
catalogue-offered = offered
catalogue-retired = retired
catalogue-none = No models
catalogue-none-found = No model begins with these words; search by fewer letters.
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
catalogue-before = Before
catalogue-after = After
catalogue-correct = Correct
catalogue-correct-model = Correct { $model }
catalogue-correct-title = Correct a model
catalogue-correct-save = Store the correction
catalogue-retire = Retire
catalogue-restore = Offer again
catalogue-add = Add a model
catalogue-add-title = Add a model
catalogue-add-save = Add the model
catalogue-make = Make
catalogue-model-name = Model
catalogue-year-from = First model year
catalogue-year-to = Last model year
catalogue-needed = This is needed.
catalogue-year-problem = Four digits, as in 2019.
catalogue-number-problem = This is no number.
catalogue-export = Export
catalogue-import = Import a CSV
catalogue-import-title = Import models from a CSV
catalogue-import-choose = Choose a CSV of models
catalogue-import-drop = Drop a CSV here
catalogue-import-hint = A header line with make and model; sizes with their unit in the header (height_m, Length (mm)).
catalogue-import-looking = Looking through the file ...
catalogue-import-unit = Unit of the sizes
catalogue-import-unit-header = as the headers say, else metres
catalogue-import-conflicts = Where the catalogue says otherwise
catalogue-import-keep = keep what it has
catalogue-import-replace = put the file’s value in its place
catalogue-import-columns = Columns of the file
catalogue-import-in = in { $unit }
catalogue-import-left-out = left out
catalogue-import-lines = Lines to look at
catalogue-import-line = Line
catalogue-import-what = What
catalogue-import-why = Why
catalogue-import-store = { $count ->
    [0] Nothing to store
    [one] Store { NUMBER($count) } model
   *[other] Store { NUMBER($count) } models
}
catalogue-import-done = { NUMBER($added) } models added, { NUMBER($updated) } updated.
catalogue-change-new = new
catalogue-change-update = filled in
catalogue-change-same = unchanged
catalogue-change-conflict = in conflict
catalogue-change-duplicate = twice in the file
catalogue-change-refused = cannot be used
catalogue-unit-m = metres
catalogue-unit-cm = centimetres
catalogue-unit-mm = millimetres
catalogue-unit-ft = feet
catalogue-unit-in = inches

## Catalogue: what an import says of a line, and what cannot be stored
catalogue-make-and-model = The make and the model are needed; fill in both.
catalogue-too-long = A make has at most { $most_make } signs and a model { $most_model }; shorten it.
catalogue-years-reversed = The last year lies before the first; swap them.
catalogue-size-impossible = { $column } is { $value }, which no vehicle has; give it in metres, from { $low } to { $high }.
catalogue-size-in-other-unit = { $column } is { $value }, which no vehicle has in metres; in { $unit } it would be { $metres } m. Give it in metres, or say the unit.
catalogue-u-impossible = { $column } is { $value }, which is no standard uncertainty of a size; give metres, from 0 to 1.
catalogue-unit-doubtful = { $column }: half of its values are { $middle } or more, which no list of vehicles has in { $unit }; they look like { $other }. Nothing is stored; say that the unit is { $sign }, or convert the file.
catalogue-there-already = { $make } { $model } ({ $year }) is in the catalogue already; correct that row instead.
catalogue-changed-meanwhile = Somebody changed { $make } { $model } meanwhile; look at it again and redo your change.
catalogue-no-such-field = The catalogue has no field “{ $field }”; use one of { $known }.
catalogue-column-choice = “{ $column }” says nothing of a column; write the field, an equals sign and the header (height_m=Roof).
catalogue-duplicate = The same model as line { $line }; left out.
catalogue-duplicate-differs = The same model as line { $line } with other values ({ $differences }); left out. Keep one of the two.
catalogue-conflict-keep = { $differences }; what the catalogue has stays.
catalogue-conflict-replace = { $differences }; this line takes its place.
catalogue-differs = { $here } here, { $there } there
catalogue-fills-in = Fills in { $columns }.

studies-fleet-header = { $path } needs a column category (or lighting, stratum, site), or the two columns variable and class, and a column share or registrations; add them.
studies-fleet-variable = { $path }, row { $row }: { $cell } is nothing that a fleet can be divided by; use one of { $known }.
studies-fleet-class-twice = { $path }, row { $row }: { $name } is there twice; keep one row.
studies-fleet-empty = { $path } has no row; give one row a class.
studies-shares-do-not-sum = { $path }: the shares of { $variable } sum to { $total }, not to 1; correct them, or give registrations in their place.
studies-registrations-do-not-sum = { $path }: { $first } sums to { $first_sum } vehicles and { $other } to { $other_sum }; both must be the same fleet.
studies-sites-header = { $path } needs the columns site and stratum; add them.
studies-sites-there-differ = { $path }, row { $row }: stratum { $stratum } has another sites_there further up; write the same number, or none, in each of its rows.
studies-traffic-of-some = { $path }: traffic stands for some sites only, or is 0; give it for all sites or for none.
studies-not-csv = { $path } cannot be read as CSV ({ $why }); save it as CSV in UTF-8.
studies-not-an-amount = { $path }, row { $row }: { $name } is { $cell }, not a number from 0; correct it.
studies-no-package-there = { $place } is no package and holds none; name exported folders or ZIPs, or a folder of them.
studies-package-does-not-verify = { $place } does not verify, so that no study is made of it: { $problem }
studies-package-without-sample = { $place } does not say which vehicles were in its sample, for it was made by an earlier version; export its survey again.
studies-package-without-parquet = { $place } was made by an earlier version, without Parquet; export its survey again.
studies-survey-without-poses = { $place } has no road pose, and so no height; leave it out, or pose its recordings (and export a package again).
studies-same-survey-twice = { $first } and { $second } are packages of the same survey; keep the later one.
studies-packages-of-two-versions = { $first } (version { $first_version }) and { $second } (version { $second_version }) have other columns in { $table }; export both with one version.
studies-no-height-counts = None of the surveys has an accepted height in its sample; review measurements (and export a package again).
studies-class-unknown = The fleet has { $variable } { $name }, which Sightline does not know; use { $known }.
studies-class-never-seen = The fleet has { $variable } { $name }, which no survey saw; leave it out and let the other shares sum to 1, or measure some.
studies-class-not-in-fleet = The surveys saw { $count } vehicles of { $variable } { $name }, which the fleet does not have; add a row for it (0 if it is not to count).
studies-site-not-in-sites = The table of sites has no row for { $site }; add it.
studies-more-sites-than-there = Stratum { $stratum } has { $count } sites here, but sites_there says { $there }; correct it.
studies-needs-a-name = A study needs a name; fill it in.
studies-has-no-survey = The study has no survey; add at least one.
studies-goal-of-study = { $goal } m is no U95 between 0 and 1 m; 0.010 m is 10 mm.
studies-survey-stands-twice = { $name } stands in the study twice; keep it once.
studies-no-year = { $year } is no year that { $name } can stand for; correct it, or leave it empty.
studies-site-in-two-strata = Site { $site } is of stratum { $first } and of { $second }; give it one, in all its surveys and in the table of sites.
studies-site-without-stratum = Site { $site } has no stratum, though others have one; give every site one, or none.
studies-changed-meanwhile = { $name } changed this study on { $when }. Load it again and redo your change.
studies-goal-no-length = --goal { $goal } is no U95 in metres between 0 and 1; 0.010 is 10 mm.
commands-compare-two-values = --compare { $text } needs --by and two different values of its column, as in --by year --compare 2020,2026.
commands-compare-no-such-value = No row with a height has { $name } in { $by }; compare two of { $known }.

## The page that a package carries (index.html): read without a server; it shares no code with what measured

opened-reading = Reading the package…
opened-unreadable = This page cannot read the package that it carries. Use a browser of 2023 or later, or run sightline verify.
opened-made-with = Made with Sightline { $version }.
opened-report = Report (PDF)
opened-measurements = Measurements
opened-figures = Figures
opened-tables = Tables
opened-sizes = Sizes
opened-checking = Checking the package…
opened-is-fine = Nothing in what this page can check contradicts anything else.
opened-is-wrong = This package is not as it was made.
opened-failed = The package cannot be read to its end: { $words }.
opened-heights-agree = { $count ->
    [one] The height was computed again from its clicks and agrees.
   *[other] { NUMBER($count) } heights were computed again from their clicks and agree.
  } The largest difference is { NUMBER($off_um, maximumFractionDigits: 2) } µm; tables are written to the micrometre.
opened-heights-refused = { $count ->
    [one] One was not computed: see its line.
   *[other] { NUMBER($count) } were not computed: see their lines.
  }
opened-heights-differ = { $count ->
    [one] One measurement differs from what its clicks give: { $named }.
   *[other] { NUMBER($count) } measurements differ from what their clicks give: { $named }.
  }
opened-chain-whole = { $count ->
    [one] The audit chain of 1 event is whole.
   *[other] The audit chain of { NUMBER($count) } events is whole: each holds what was hashed and follows the one before.
  }
opened-chain-broken = The audit chain is broken at event { $number }.
opened-chain-absent = The audit chain was not checked: audit.js does not lie beside this page, or the chain is too large for a page. Use sightline verify.
opened-seal-none = The audit chain does not end with the seal of a package.
opened-seal-chain = The audit chain before the seal is not the one that the seal names.
opened-seal-holds = The { NUMBER($count) } files that this page carries are those that the seal names.
opened-seal-wrong = Not the files that the seal names: { $named }.
opened-rows-agree = Every measurement says what its audit event says.
opened-rows-differ = { $count ->
    [one] One measurement is not what its audit event says: { $named }.
   *[other] { NUMBER($count) } measurements are not what their audit events say: { $named }.
  }
opened-poses-agree = Every road pose is the one that its audit event names.
opened-poses-differ = Not the road poses that their audit events name: { $named }.
opened-signature-holds = Signed on { $at } with key { $key }…: compare it with the one that the installation shows.
opened-signature-wrong = The signature does not hold for the end of this chain.
opened-signature-unknown = The signature was not checked, for this browser has no Ed25519. Use sightline verify.
opened-folder-choose = Check the files of the folder too: choose the folder in which this page lies. Nothing leaves this computer.
opened-folder-checking = Checking the files…
opened-folder-fine = All { NUMBER($count) } files of the folder ({ NUMBER($mb, maximumSignificantDigits: 2) } MB) are those that the seal names.
opened-folder-changed = Changed after the export: { $named }.
opened-folder-missing = Missing from the folder: { $named }.
opened-folder-strange = Not part of the package: { $named }.
opened-what-title = What is checked where
opened-what-here = Here, from the copies of the tables that this page carries: every height in force from clicks, lens and road pose, by arithmetic of this page’s own; U95 as 1.96 u and u as the root sum of squares of its budget; the audit chain with its seal and signature; every measurement and road pose against its audit event.
opened-what-folder = Only once you choose the folder: whether the files beside this page (pictures, figures, report, tables) are those that the seal names. A browser does not let a page read its neighbours unasked.
opened-what-verify = Only by sightline verify: earlier revisions and repeats, the parts of the budgets, verdicts against reviews, vehicles, line scans, the statistics, figures and report made again, Parquet against CSV.
opened-what-page = A page can be forged as a whole, and would then say what its forger likes. For a verdict that matters run sightline verify with the key that the installation shows.
opened-measurements-none = No measurement in this package.
opened-figures-none = No figures: too few accepted measurements.
opened-left-out = Too large for this page, so neither shown nor checked here: { $named }. Use sightline verify.
opened-table-empty = No rows.
opened-table-cut = The first { NUMBER($shown) } of { NUMBER($count) } rows; the file has all.
opened-sizes-total = { NUMBER($files) } files, { NUMBER($mb, maximumSignificantDigits: 3) } MB, beside this page, the description, the audit chain and the list of sums.
opened-size-top = { NUMBER($files) } files at the top, { NUMBER($mb, maximumSignificantDigits: 2) } MB
opened-size = { $folder } { NUMBER($files) } files, { NUMBER($mb, maximumSignificantDigits: 2) } MB
opened-filter = Show
opened-filter-all = all
opened-filter-differs = those that differ
opened-before = Previous
opened-after = Next
opened-range = { NUMBER($from) } to { NUMBER($to) } of { NUMBER($count) }
opened-target-roof = Roof
opened-target-driver_eye = Driver’s eye
opened-target-taillight = Taillight
opened-target-headlight = Headlight
opened-target-other = Other
opened-verdict-accepted = accepted
opened-verdict-fixed = corrected
opened-verdict-rejected = rejected
opened-verdict-unreviewed = not reviewed
opened-withdrawn = withdrawn
opened-column-id = No.
opened-column-target = Target
opened-column-package = Height in the package
opened-column-here = Computed here
opened-column-review = Review
opened-height = { $height_m } ± { $U95_m } m
opened-height-here = { $height_m } m
opened-height-none = no height
opened-refused-pose = not computed: its road pose is not in the package
opened-refused-form = not computed: its frames are not all in the table
opened-one = Measurement { $id }: { $target }
opened-crops-none = No picture of it in this package.
opened-crop = Frame { $frame } with both points
opened-differs = Not what the clicks give: { $named }.
opened-pair-package = Height in the package, m
opened-pair-here = Computed in this page
opened-pair-off = Difference
opened-nanometres = { $off_nm } nm
opened-pair-contact = Tyre contact, px
opened-pair-target = Target, px
opened-pair-inset = Inset, m
opened-pair-frame = Recording and frame
opened-pair-pose = Road pose
opened-pair-u = u from { $source }, m
